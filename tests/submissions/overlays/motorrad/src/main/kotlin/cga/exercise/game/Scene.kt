package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import cga.framework.GLError
import cga.framework.GameWindow
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.Math
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL30.*
import kotlin.math.sin

class Scene(private val window: GameWindow) {
    private val staticShader: ShaderProgram
    // private val simpleShader: ShaderProgram

    private var boden: Renderable
    private var motorrad: Renderable
    // private var kugel: Renderable

    private var kamera: TronCamera

    private var motorradLicht: PointLight
    private var scheinwerfer: SpotLight
    private var ecke1: PointLight
    private var ecke2: PointLight
    private var ecke3: PointLight
    private var ecke4: PointLight

    private val bodenFarbe = Vector3f(0.0f, 1.0f, 0.0f)
    private var motorradFarbe = Vector3f(1.0f, 1.0f, 1.0f)

    private var ersteMausbewegung = true
    private var alteMausX = 0.0
    private var scheinwerferAn = true

    // scene setup
    init {
        staticShader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")
        // simpleShader = ShaderProgram("assets/shaders/simple_vert.glsl", "assets/shaders/simple_frag.glsl")

        // initial opengl state
        glClearColor(0.0f, 0.0f, 0.0f, 1.0f); GLError.checkThrow()
        glEnable(GL_CULL_FACE); GLError.checkThrow()
        glFrontFace(GL_CCW); GLError.checkThrow()
        glCullFace(GL_BACK); GLError.checkThrow()
        glEnable(GL_DEPTH_TEST); GLError.checkThrow()
        glDepthFunc(GL_LESS); GLError.checkThrow()

        // Blatt 1: Haus
        // val vertices = floatArrayOf(
        //     -0.5f, -0.5f, 0.0f, 0.0f, 0.0f, 1.0f,
        //      0.5f, -0.5f, 0.0f, 0.0f, 0.0f, 1.0f,
        // )

        // Boden
        val diff = Texture2D("assets/textures/ground_diff.png", true)
        diff.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val emit = Texture2D("assets/textures/ground_emit.png", true)
        emit.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val spec = Texture2D("assets/textures/ground_spec.png", true)
        spec.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val bodenMaterial = Material(diff, emit, spec, 60.0f, Vector2f(64.0f, 64.0f))

        val res = OBJLoader.loadOBJ("assets/models/ground.obj")
        val stride = 8 * 4
        val attrPos = VertexAttribute(3, stride, 0)
        val attrTC = VertexAttribute(2, stride, 3 * 4)
        val attrNorm = VertexAttribute(3, stride, 5 * 4)
        val bodenMesh = Mesh(res.vertexData, res.indexData, arrayOf(attrPos, attrTC, attrNorm), bodenMaterial)
        boden = Renderable(mutableListOf(bodenMesh))

        // Motorrad
        motorrad = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)
            ?: throw Exception("Motorrad konnte nicht geladen werden")
        motorrad.scaleLocal(Vector3f(0.8f))

        // Kamera
        kamera = TronCamera()
        kamera.parent = motorrad
        kamera.rotateLocal(Math.toRadians(-30.0f), 0.0f, 0.0f)
        kamera.translateLocal(Vector3f(0.0f, 0.0f, 4.5f))

        // Lichter
        motorradLicht = PointLight(Vector3f(0.0f, 2.0f, 0.0f), Vector3f(1.0f, 1.0f, 1.0f))
        motorradLicht.parent = motorrad

        scheinwerfer = SpotLight(Vector3f(0.0f, 1.0f, -2.0f), Vector3f(3.0f, 3.0f, 3.0f), Math.toRadians(15.0f), Math.toRadians(30.0f))
        scheinwerfer.rotateLocal(Math.toRadians(-12.0f), 0.0f, 0.0f)
        scheinwerfer.parent = motorrad

        ecke1 = PointLight(Vector3f(16.0f, 2.0f, 16.0f), Vector3f(8.0f, 0.0f, 0.0f))
        ecke2 = PointLight(Vector3f(-16.0f, 2.0f, 16.0f), Vector3f(0.0f, 0.0f, 8.0f))
        ecke3 = PointLight(Vector3f(16.0f, 2.0f, -16.0f), Vector3f(8.0f, 6.0f, 0.0f))
        ecke4 = PointLight(Vector3f(-16.0f, 2.0f, -16.0f), Vector3f(7.0f, 0.0f, 7.0f))
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)

        staticShader.use()
        kamera.bind(staticShader)

        motorradFarbe = Vector3f(0.5f + 0.5f * sin(t), 0.5f + 0.5f * sin(t / 2 + 2.0f), 0.5f + 0.5f * sin(t / 3 + 4.0f))
        motorradLicht.lichtFarbe = motorradFarbe

        motorradLicht.bind(staticShader, "motorradLicht")
        scheinwerfer.bind(staticShader, "scheinwerfer", kamera.getCalculateViewMatrix())
        if (!scheinwerferAn) staticShader.setUniform("scheinwerferFarbe", Vector3f(0.0f, 0.0f, 0.0f))
        ecke1.bind(staticShader, "ecke1")
        ecke2.bind(staticShader, "ecke2")
        ecke3.bind(staticShader, "ecke3")
        ecke4.bind(staticShader, "ecke4")

        staticShader.setUniform("farbe", bodenFarbe)
        boden.render(staticShader)

        staticShader.setUniform("farbe", motorradFarbe)
        motorrad.render(staticShader)
        // kugel.render(staticShader)
    }

    fun update(dt: Float, t: Float) {
        var tempo = 5.0f
        if (window.getKeyState(GLFW_KEY_LEFT_SHIFT)) tempo = 12.0f // Turbo

        if (window.getKeyState(GLFW_KEY_W)) {
            motorrad.translateLocal(Vector3f(0.0f, 0.0f, -tempo * dt))
            if (window.getKeyState(GLFW_KEY_A)) motorrad.rotateLocal(0.0f, 1.5f * dt, 0.0f)
            if (window.getKeyState(GLFW_KEY_D)) motorrad.rotateLocal(0.0f, -1.5f * dt, 0.0f)
        }
        if (window.getKeyState(GLFW_KEY_S)) {
            motorrad.translateLocal(Vector3f(0.0f, 0.0f, tempo * dt))
            if (window.getKeyState(GLFW_KEY_A)) motorrad.rotateLocal(0.0f, -1.5f * dt, 0.0f)
            if (window.getKeyState(GLFW_KEY_D)) motorrad.rotateLocal(0.0f, 1.5f * dt, 0.0f)
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {
        if (key == GLFW_KEY_L && action == GLFW_PRESS) {
            scheinwerferAn = !scheinwerferAn
            println("Scheinwerfer: $scheinwerferAn")
        }
    }

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (ersteMausbewegung) {
            alteMausX = xpos
            ersteMausbewegung = false
        }
        val differenz = xpos - alteMausX
        alteMausX = xpos
        // println("Maus: $differenz")
        val winkel = (differenz * 0.002).toFloat()
        kamera.rotateAroundPoint(0.0f, winkel, 0.0f, Vector3f(0.0f, 0.0f, 0.0f))
    }

    fun cleanup() {
        boden.cleanup()
        motorrad.cleanup()
        staticShader.cleanup()
    }
}
