package cga.exercise.components.geometry

/** n floats, [offset] bytes after the beginning of a vertex; the next vertex begins after [stride] bytes. */
data class VertexAttribute(val n: Int, val stride: Int, val offset: Int)
