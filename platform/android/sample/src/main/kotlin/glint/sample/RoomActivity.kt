// The Cornell room, and over it how fast it comes.
package glint.sample

import android.app.Activity
import android.graphics.Color
import android.os.Bundle
import android.view.ViewGroup.LayoutParams.WRAP_CONTENT
import android.widget.FrameLayout
import android.widget.TextView
import glint.android.GlintFigures
import glint.android.GlintScene
import glint.android.GlintView

class RoomActivity : Activity() {
    private lateinit var view: GlintView
    private lateinit var label: TextView
    private lateinit var scene: GlintScene
    private val tell = Runnable { tellFigures() }

    override fun onCreate(savedInstanceState: Bundle?) {
        super.onCreate(savedInstanceState)
        scene = GlintScene.fromAssets(this, "cornell.sdl")
        view = GlintView(this)
        view.setScene(scene, depth = 2)
        label = TextView(this).apply {
            setTextColor(Color.WHITE)
            setShadowLayer(4f, 1f, 1f, Color.BLACK)
            setPadding(24, 24, 24, 24)
        }
        setContentView(
            FrameLayout(this).apply {
                addView(view)
                addView(label, FrameLayout.LayoutParams(WRAP_CONTENT, WRAP_CONTENT))
            },
        )
    }

    override fun onResume() {
        super.onResume()
        view.onResume()
        tellFigures()
    }

    override fun onPause() {
        label.removeCallbacks(tell)
        view.onPause()
        super.onPause()
    }

    override fun onDestroy() {
        scene.close()
        super.onDestroy()
    }

    private fun tellFigures() {
        view.figures?.let { label.text = describe(it) }
        label.postDelayed(tell, 250)
    }

    private fun describe(figures: GlintFigures): String =
        "%.1f frames a second\n%.2f ms traced\n%d x %d, depth %d, samples %d".format(
            figures.framesPerSecond, figures.renderMs,
            figures.widthPx, figures.heightPx, figures.depth, figures.samplesPerPixel,
        )
}
