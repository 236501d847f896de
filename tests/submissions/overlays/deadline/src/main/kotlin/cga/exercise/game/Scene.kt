package cga.exercise.game

import cga.exercise.components.camera.TronCamera
import cga.exercise.components.geometry.Material
import cga.exercise.components.geometry.Mesh
import cga.exercise.components.geometry.Renderable
import cga.exercise.components.geometry.Transformable
import cga.exercise.components.geometry.VertexAttribute
import cga.exercise.components.light.PointLight
import cga.exercise.components.light.SpotLight
import cga.exercise.components.shader.ShaderProgram
import cga.exercise.components.texture.Texture2D
import cga.framework.GameWindow
import cga.framework.ModelLoader
import cga.framework.OBJLoader
import org.joml.Math
import org.joml.Vector2f
import org.joml.Vector3f
import org.lwjgl.glfw.GLFW.*
import org.lwjgl.opengl.GL11.*
import kotlin.math.cos
import kotlin.math.sin

class Scene(private val window: GameWindow) {
    private val staticShader: ShaderProgram
    private val boden: Renderable
    private val motorrad: Renderable
    private val camera: TronCamera
    private val pivot = Transformable()

    private val pointLight: PointLight
    private val spotLight: SpotLight
    private val ecke1: PointLight
    private val ecke2: PointLight
    private val ecke3: PointLight
    private val ecke4: PointLight

    private var firstMouse = true
    private var oldX = 0.0

    init {
        staticShader = ShaderProgram("assets/shaders/tron_vert.glsl", "assets/shaders/tron_frag.glsl")

        glClearColor(0.0f, 0.0f, 0.0f, 1.0f)
        glEnable(GL_CULL_FACE)
        glFrontFace(GL_CCW)
        glCullFace(GL_BACK)
        glEnable(GL_DEPTH_TEST)
        glDepthFunc(GL_LESS)

        //Boden
        val bodenDiff = Texture2D("assets/textures/ground_diff.png", true)
        bodenDiff.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val bodenEmit = Texture2D("assets/textures/ground_emit.png", true)
        bodenEmit.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val bodenSpec = Texture2D("assets/textures/ground_spec.png", true)
        bodenSpec.setTexParams(GL_REPEAT, GL_REPEAT, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR)
        val bodenMaterial = Material(bodenDiff, bodenEmit, bodenSpec, 60.0f, Vector2f(64.0f, 64.0f))
        val res = OBJLoader.loadOBJ("assets/models/ground.obj")
        val attribs = arrayOf(VertexAttribute(3, 32, 0), VertexAttribute(2, 32, 12), VertexAttribute(3, 32, 20))
        boden = Renderable(mutableListOf(Mesh(res.vertexData, res.indexData, attribs, bodenMaterial)))

        //Motorrad
        motorrad = ModelLoader.loadModel("assets/models/motorcycle/motorcycle.obj", 0.0f, 0.0f, 0.0f)!!
        motorrad.scaleLocal(Vector3f(0.8f))

        //Kamera haengt am Pivot, Pivot haengt am Motorrad
        camera = TronCamera()
        pivot.parent = motorrad
        pivot.translateLocal(Vector3f(0.0f, 0.5f, 0.0f))
        camera.parent = pivot
        camera.translateLocal(Vector3f(0.0f, 1.6f, 3.9f))
        camera.rotateLocal(Math.toRadians(-24.0f), 0.0f, 0.0f)

        //Lichter
        pointLight = PointLight(Vector3f(0.0f, 1.7f, 0.5f), Vector3f(1.0f, 0.0f, 1.0f))
        pointLight.parent = motorrad
        spotLight = SpotLight(Vector3f(0.0f, 1.0f, -1.9f), Vector3f(3.0f, 3.0f, 3.0f), Math.toRadians(13.0f), Math.toRadians(24.0f))
        spotLight.rotateLocal(Math.toRadians(-11.0f), 0.0f, 0.0f)
        spotLight.parent = motorrad
        ecke1 = PointLight(Vector3f(16.0f, 1.6f, 16.0f), Vector3f(8.0f, 1.0f, 1.0f))
        ecke2 = PointLight(Vector3f(-16.0f, 1.6f, 16.0f), Vector3f(1.0f, 8.0f, 6.0f))
        ecke3 = PointLight(Vector3f(16.0f, 1.6f, -16.0f), Vector3f(1.0f, 1.0f, 9.0f))
        ecke4 = PointLight(Vector3f(-16.0f, 1.6f, -16.0f), Vector3f(8.0f, 5.0f, 0.0f))
    }

    fun render(dt: Float, t: Float) {
        glClear(GL_COLOR_BUFFER_BIT or GL_DEPTH_BUFFER_BIT)
        staticShader.use()
        camera.bind(staticShader)

        //Punktlicht am Motorrad
        pointLight.lightColor = Vector3f(sin(0.5f * t) * 0.5f + 0.5f, cos(0.8f * t) * 0.5f + 0.5f, sin(1.1f * t) * 0.5f + 0.5f)
        pointLight.bind(staticShader, "")

        //Scheinwerfer
        spotLight.bind(staticShader, "spot_", camera.getCalculateViewMatrix())

        //Ecken
        ecke1.bind(staticShader, "ecke1_")
        ecke2.bind(staticShader, "ecke2_")
        ecke3.bind(staticShader, "ecke3_")
        ecke4.bind(staticShader, "ecke4_")

        //Boden gruen
        staticShader.setUniform("farbe", Vector3f(0.0f, 1.0f, 0.0f))
        boden.render(staticShader)

        //Motorrad bunt, gleiche Farbe wie Licht
        val rot = sin(0.5f * t) * 0.5f + 0.5f
        val gruen = cos(0.8f * t) * 0.5f + 0.5f
        val blau = sin(1.1f * t) * 0.5f + 0.5f
        staticShader.setUniform("farbe", Vector3f(rot, gruen, blau))
        motorrad.render(staticShader)
    }

    fun update(dt: Float, t: Float) {
        if (window.getKeyState(GLFW_KEY_W)) {
            motorrad.translateLocal(Vector3f(0.0f, 0.0f, -6.0f * dt))
            if (window.getKeyState(GLFW_KEY_A)) motorrad.rotateLocal(0.0f, 1.2f * dt, 0.0f)
            if (window.getKeyState(GLFW_KEY_D)) motorrad.rotateLocal(0.0f, -1.2f * dt, 0.0f)
        }
        if (window.getKeyState(GLFW_KEY_S)) {
            motorrad.translateLocal(Vector3f(0.0f, 0.0f, 4.0f * dt))
        }
    }

    fun onKey(key: Int, scancode: Int, action: Int, mode: Int) {}

    fun onMouseMove(xpos: Double, ypos: Double) {
        if (firstMouse) {
            oldX = xpos
            firstMouse = false
        }
        val diffX = (xpos - oldX).toFloat()
        oldX = xpos
        pivot.rotateLocal(0.0f, -diffX * 0.002f, 0.0f)
    }

    fun cleanup() {
        boden.cleanup()
        motorrad.cleanup()
        staticShader.cleanup()
    }
}
