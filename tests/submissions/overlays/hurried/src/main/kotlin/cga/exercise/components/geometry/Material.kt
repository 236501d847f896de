package cga.exercise.components.geometry

import cga.exercise.components.texture.Texture2D

class Material(val diff: Texture2D, val emit: Texture2D, val spec: Texture2D, val shininess: Float, val tiles: Float = 1.0f)
