package cga.exercise.components.light

interface ISpotLight : IPointLight
