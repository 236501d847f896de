package cga.grading.sheet4.scene

import cga.grading.findings.Message
import cga.grading.scene.Shot
import cga.grading.scene.rotationPart
import cga.grading.scene.scale
import cga.grading.scene.translation
import org.joml.Matrix4d
import org.joml.Matrix4dc

/** What carries a light: its own space → world space. Wanted is the motorcycle. */
internal enum class Parent(val rides: Boolean, val key: String, val matrix: (Shot) -> Matrix4dc) {
    MOTORCYCLE(true, "place.moves-and-turns", { it.motorcycle }),
    WORLD(false, "place.stays", { Matrix4d() }),
    FOLLOWER(true, "place.moves-only", { Matrix4d().translation(it.motorcycle.translation()) }),
    TWICE(true, "place.model-twice", { Matrix4d(it.motorcycle).mul(it.motorcycle) }),
}

/** What takes a light from world space to where it is used as if that were view space. Wanted is the view matrix. */
internal enum class Space(val key: String, val matrix: (Shot) -> Matrix4dc) {
    VIEW("place.stays", { it.view }),
    RAW("place.never-viewed", { Matrix4d() }),
    SCALED("place.stretched", { Matrix4d().scaling(1 / it.motorcycle.scale()).mul(it.view) }),
    TWICE("place.view-twice", { Matrix4d(it.view).mul(it.view) }),
    TURNED("place.turned-only", { Matrix4d().set(it.viewTurn) }),
    CAMERA("place.camera-matrix", { it.fromView }),
    TRANSPOSED("place.transposed", { Matrix4d().set(it.viewTurn).transpose() }),
    FIRST_VIEW("place.first-view", { it.firstView }),
}

/**
 * A hypothesis: that what acts as a light's place or direction in view space is [space] · [parent] · something constant. All but the right
 * one are the right one with one factor changed.
 */
internal data class Chain(val space: Space, val parent: Parent) {
    /** Whether the numbers are in view space at all, whatever carries the light. */
    val isViewed: Boolean get() = space == Space.VIEW && parent != Parent.TWICE

    /** Whether such a light moves with the motorcycle; null where that cannot be told. */
    val rides: Boolean? get() = if (this == CONSTANT) null else parent.rides

    /** What is said of it, for people. */
    val text: Message
        get() = say(
            when {
                this == CONSTANT -> "place.constant"
                isViewed || parent == Parent.TWICE -> parent.key
                else -> space.key
            },
        )

    fun matrix(shot: Shot): Matrix4dc = Matrix4d(space.matrix(shot)).mul(parent.matrix(shot))

    /** What it does to directions. */
    fun turn(shot: Shot): Matrix4dc = Matrix4d().set(rotationPart(space.matrix(shot)).mul(rotationPart(parent.matrix(shot))))

    companion object {
        val CHILD = Chain(Space.VIEW, Parent.MOTORCYCLE)
        val STATIC = Chain(Space.VIEW, Parent.WORLD)
        val FOLLOWER = Chain(Space.VIEW, Parent.FOLLOWER)
        val CONSTANT = Chain(Space.RAW, Parent.WORLD)

        /** Of places, the simplest first. */
        val PLACES: List<Chain> =
            listOf(CHILD, STATIC, FOLLOWER) +
                Space.entries.drop(1).flatMap { listOf(Chain(it, Parent.MOTORCYCLE), Chain(it, Parent.WORLD)) } +
                Chain(Space.VIEW, Parent.TWICE)

        /** Of directions, the simplest first. */
        val AIMS: List<Chain> =
            listOf(CHILD, Chain(Space.RAW, Parent.MOTORCYCLE), CONSTANT, STATIC) +
                listOf(Space.CAMERA, Space.TWICE, Space.FIRST_VIEW).map { Chain(it, Parent.MOTORCYCLE) }
    }
}
