package cga.reader.lower

import cga.reader.shader.Operation
import cga.reader.shader.Operation.ADD
import cga.reader.shader.Operation.DIV
import cga.reader.shader.Operation.INVERSE_SQRT
import cga.reader.shader.Operation.LESS
import cga.reader.shader.Operation.MAX
import cga.reader.shader.Operation.MIN
import cga.reader.shader.Operation.MUL
import cga.reader.shader.Operation.NEG
import cga.reader.shader.Operation.SELECT
import cga.reader.shader.Operation.SQRT
import cga.reader.shader.Operation.SUB
import cga.reader.spirv.Instruction
import cga.reader.spirv.Type
import cga.reader.spirv.UnreadableException

/** The functions of GLSL that SPIR-V has in its set `GLSL.std.450`: as operations, or as the formulas that GLSL gives for them. */
internal class StandardFunctions(
    private val emitter: Emitter,
    private val arithmetic: Arithmetic,
    private val algebra: Algebra,
) {
    fun lower(instruction: Instruction, scope: Scope): Value {
        val type = scope.type(instruction.type)
        val number = instruction.operands[1]
        val name = NAMES.getOrNull(number).orEmpty()
        emitter.origin = name
        DIRECT[name]?.let { operation -> return arithmetic.each(type, operation, instruction.from(2).map(scope::value)) }
        val formula = formulas[name] ?: throw UnreadableException("the function $number ($name) of GLSL.std.450 is not known")
        return formula(type, instruction.from(2).map(scope::value))
    }

    private val formulas: Map<String, (Type, List<Value>) -> Value> = mapOf(
        "radians" to { type, (x) -> each(type, MUL, x, number(Math.PI / 180)) },
        "degrees" to { type, (x) -> each(type, MUL, x, number(180 / Math.PI)) },
        "determinant" to { type, (matrix) -> Value(type, algebra.determinant(matrix)) },
        "inverse" to { type, (matrix) -> algebra.inverse(type, matrix) },
        "clamp" to { type, (x, low, high) -> each(type, MIN, each(type, MAX, x, low), high) },
        "mix" to { type, (x, y, a) -> each(type, ADD, each(type, MUL, x, each(a.type, SUB, number(1.0), a)), each(type, MUL, y, a)) },
        "step" to { type, (edge, x) -> each(type, SELECT, each(type, LESS, x, edge), number(0.0), number(1.0)) },
        "smoothstep" to { type, (low, high, x) ->
            val share = each(type, DIV, each(type, SUB, x, low), each(type, SUB, high, low))
            val t = each(type, MIN, each(type, MAX, share, number(0.0)), number(1.0))
            each(type, MUL, each(type, MUL, t, t), each(type, SUB, number(3.0), each(type, MUL, number(2.0), t)))
        },
        "modfStruct" to { type, (x) ->
            val whole = each(x.type, Operation.TRUNC, x)
            Value(type, each(x.type, SUB, x, whole).cells + whole.cells)
        },
        "fma" to { type, (a, b, c) -> each(type, ADD, each(type, MUL, a, b), c) },
        "length" to { type, (v) -> length(type, v) },
        "distance" to { type, (a, b) -> length(type, each(a.type, SUB, a, b)) },
        "cross" to { type, (a, b) ->
            fun rotated(v: Value, by: Int) = Value(type, IntArray(3) { v.cells[(it + by) % 3] })
            each(type, SUB, each(type, MUL, rotated(a, 1), rotated(b, 2)), each(type, MUL, rotated(b, 1), rotated(a, 2)))
        },
        "normalize" to { type, (v) -> each(type, MUL, v, each(type.componentType, INVERSE_SQRT, dot(v, v))) },
        "faceforward" to { type, (n, i, reference) ->
            each(type, SELECT, each(type.componentType, LESS, dot(reference, i), number(0.0)), n, each(type, NEG, n))
        },
        "reflect" to { type, (i, n) -> each(type, SUB, i, each(type, MUL, each(type.componentType, MUL, number(2.0), dot(n, i)), n)) },
        "refract" to { type, (i, n, eta) -> refract(type, i, n, eta) },
    )

    private fun length(
        type: Type,
        v: Value,
    ) = if (v.cells.size == 1) each(type, Operation.ABS, v) else each(type, SQRT, dot(v, v))

    private fun refract(type: Type, i: Value, n: Value, eta: Value): Value {
        val cosine = dot(n, i)
        val sine = each(Type.Float, MUL, each(Type.Float, MUL, eta, eta), each(Type.Float, SUB, number(1.0), product(cosine, cosine)))
        val k = each(Type.Float, SUB, number(1.0), sine)
        val along = each(Type.Float, ADD, product(eta, cosine), each(Type.Float, SQRT, each(Type.Float, MAX, k, number(0.0))))
        val refracted = each(type, SUB, each(type, MUL, i, eta), each(type, MUL, n, along))
        return each(type, SELECT, each(Type.Float, LESS, k, number(0.0)), number(0.0), refracted)
    }

    private fun product(a: Value, b: Value) = each(Type.Float, MUL, a, b)

    private fun dot(a: Value, b: Value) = Value(Type.Float, algebra.dot(a.cells, b.cells))

    private fun number(value: Double) = Value(Type.Float, emitter.constant(value))

    private fun each(
        type: Type,
        operation: Operation,
        vararg operands: Value,
    ) = arithmetic.each(type, operation, operands.asList())

    private companion object {
        /** By their numbers in the specification. */
        val NAMES = (
            " round roundEven trunc abs sAbs sign sSign floor ceil fract radians degrees sin cos tan asin acos atan sinh cosh " +
                "tanh asinh acosh atanh atan2 pow exp log exp2 log2 sqrt inversesqrt determinant inverse modf modfStruct min uMin " +
                "sMin max uMax sMax clamp clamp clamp mix iMix step smoothstep fma frexp frexpStruct ldexp packSnorm4x8 packUnorm4x8 " +
                "packSnorm2x16 packUnorm2x16 packHalf2x16 packDouble2x32 unpackSnorm2x16 unpackUnorm2x16 unpackHalf2x16 " +
                "unpackSnorm4x8 unpackUnorm4x8 unpackDouble2x32 length distance cross normalize faceforward reflect refract"
        ).split(' ')

        val DIRECT = mapOf(
            "round" to Operation.ROUND,
            "roundEven" to Operation.ROUND,
            "trunc" to Operation.TRUNC,
            "abs" to Operation.ABS,
            "sAbs" to Operation.ABS,
            "sign" to Operation.SIGN,
            "sSign" to Operation.SIGN,
            "floor" to Operation.FLOOR,
            "ceil" to Operation.CEIL,
            "fract" to Operation.FRACT,
            "sin" to Operation.SIN,
            "cos" to Operation.COS,
            "tan" to Operation.TAN,
            "asin" to Operation.ASIN,
            "acos" to Operation.ACOS,
            "atan" to Operation.ATAN,
            "sinh" to Operation.SINH,
            "cosh" to Operation.COSH,
            "tanh" to Operation.TANH,
            "asinh" to Operation.ASINH,
            "acosh" to Operation.ACOSH,
            "atanh" to Operation.ATANH,
            "atan2" to Operation.ATAN2,
            "pow" to Operation.POW,
            "exp" to Operation.EXP,
            "log" to Operation.LOG,
            "exp2" to Operation.EXP2,
            "log2" to Operation.LOG2,
            "sqrt" to SQRT,
            "inversesqrt" to INVERSE_SQRT,
            "min" to MIN,
            "uMin" to MIN,
            "sMin" to MIN,
            "max" to MAX,
            "uMax" to MAX,
            "sMax" to MAX,
        )
    }
}
