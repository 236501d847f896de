package cga.reader.spirv

/**
 * A type of SPIR-V. Values of it are held flat: a cell a number, matrices column by column, members and elements one after the other.
 *
 * @property cells how many numbers a value has.
 */
internal sealed class Type(
    val cells: Int,
    val depth: Int = 0,
) {
    object Void : Type(0)

    object Bool : Type(1)

    object Float : Type(1)

    class Integer(val isSigned: Boolean) : Type(1)

    class Vector(val component: Type, val count: Int) : Type(component times count, component.depth + 1)

    class Matrix(val column: Vector, val count: Int) : Type(column times count, column.depth + 1)

    class Array(val element: Type, val count: Int) : Type(element times count, element.depth + 1)

    class Struct(
        val name: String,
        val isBlock: Boolean,
        val members: List<Member>,
    ) : Type(sum(members), (members.maxOfOrNull { it.type.depth } ?: 0) + 1)

    class Member(
        val name: String,
        val type: Type,
        val builtIn: BuiltIn?,
    )

    /** What a sampler points to; one cell holds which. [dimensions] counts the coordinates of a texel, layers aside. */
    class Image(
        val dimensions: Int,
        val isCube: Boolean,
        val isArray: Boolean,
    ) : Type(1)

    class Pointer(val storage: Storage, val target: Type) : Type(0)

    object Function : Type(0)

    init {
        if (cells > MAX_CELLS) throw UnreadableException("a type of $cells numbers; at most $MAX_CELLS can be read")
        if (depth > MAX_DEPTH) throw UnreadableException("types nested more than $MAX_DEPTH deep")
    }

    /** The part of it that [index] selects, and how many cells come before it. */
    fun part(index: Int): Pair<Type, Int> {
        val (part, count) = parts()
        if (this is Struct) return members[index].type to members.take(index).sumOf { it.type.cells }
        if (index !in 0 until count) throw UnreadableException("index $index of ${this::class.simpleName} with $count parts")
        return part to index * part.cells
    }

    /** What all parts of a vector, matrix or array are, and how many; of a structure the count alone says something. */
    fun parts(): Pair<Type, Int> =
        when (this) {
            is Vector -> component to count
            is Matrix -> column to count
            is Array -> element to count
            is Struct -> this to members.size
            else -> throw UnreadableException("${this::class.simpleName} has no parts")
        }

    private companion object {
        const val MAX_CELLS = 1 shl 18
        const val MAX_DEPTH = 64

        infix fun Type.times(count: Int) = saturated(cells.toLong() * maxOf(count, 0))

        fun sum(members: List<Member>) = saturated(members.sumOf { it.type.cells.toLong() })

        fun saturated(cells: Long) = cells.coerceAtMost(Int.MAX_VALUE.toLong()).toInt()
    }
}

/** Where a variable lives. */
internal enum class Storage(val code: Int) {
    UNIFORM_CONSTANT(0),
    INPUT(1),
    UNIFORM(2),
    OUTPUT(3),
    PRIVATE(6),
    FUNCTION(7),
    ;

    companion object {
        fun of(code: Int): Storage = entries.find { it.code == code } ?: throw UnreadableException("storage class $code is not known")
    }
}

/** GLSL's own variables, by the name that they have there. */
internal enum class BuiltIn(
    val code: Int,
    val glsl: String,
) {
    POSITION(0, "gl_Position"),
    POINT_SIZE(1, "gl_PointSize"),
    CLIP_DISTANCE(3, "gl_ClipDistance"),
    CULL_DISTANCE(4, "gl_CullDistance"),
    VERTEX_ID(5, "gl_VertexID"),
    INSTANCE_ID(6, "gl_InstanceID"),
    PRIMITIVE_ID(7, "gl_PrimitiveID"),
    LAYER(9, "gl_Layer"),
    FRAG_COORD(15, "gl_FragCoord"),
    POINT_COORD(16, "gl_PointCoord"),
    FRONT_FACING(17, "gl_FrontFacing"),
    SAMPLE_ID(18, "gl_SampleID"),
    SAMPLE_POSITION(19, "gl_SamplePosition"),
    FRAG_DEPTH(22, "gl_FragDepth"),
    VERTEX_INDEX(42, "gl_VertexID"),
    INSTANCE_INDEX(43, "gl_InstanceID"),
    ;

    companion object {
        fun of(code: Int): BuiltIn = entries.find { it.code == code } ?: throw UnreadableException("built-in variable $code is not known")
    }
}
