package cga.exercise

import cga.exercise.game.Game

fun main() {
    Game(1280, 720).run()
}
