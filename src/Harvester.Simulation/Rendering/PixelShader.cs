using System;
using System.Numerics;
using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>Light and air for each pixel.</summary>
internal sealed class PixelShader
{
    private readonly View _view;
    private readonly Lighting _lighting;
    private readonly Sky _sky;
    private readonly LightMap _lights;
    private readonly Vector3 _sun;
    private readonly Vector3 _sunColour;
    private readonly Vector3 _ambient;
    private readonly float _night;
    private readonly Vector3 _right;
    private readonly Vector3 _forward;
    private readonly Vector3 _up;

    public PixelShader(RenderScene scene, View view)
    {
        _view = view;
        _lighting = scene.Lighting;
        _sky = new Sky(_lighting);
        _lights = new LightMap(scene, view);
        _sun = Sky.ToSingle(_lighting.SunDirection);
        _sunColour = Sky.ToLight(_lighting.SunColour);
        _ambient = Sky.ToLight(_lighting.AmbientColour);
        _night = (float)_lighting.NightFraction;
        Axes axes = view.Camera.Pose.Axes;
        (_right, _forward, _up) = (Sky.ToSingle(axes.Right), Sky.ToSingle(axes.Forward), Sky.ToSingle(axes.Up));
    }

    public void ShadeSky(int column, int row, Span<byte> colour)
    {
        Vector3 sky = _sky.ColourAt(Vector3.Normalize(DirectionAt(column, row)));
        float haze = Math.Min(1, (float)_lighting.FogDensity * 45);
        Write(Vector3.Lerp(sky, _sky.Horizon, haze), colour);
    }

    public void Shade(in ScreenTriangle triangle, int column, int row, float depth, Span<byte> colour)
    {
        // Everything is relative to the camera, so that single precision is enough anywhere in the world.
        Vector3 direction = DirectionAt(column, row);
        Vector3 place = direction * depth;
        float distance = place.Length();
        direction = Vector3.Normalize(direction);
        Vector3 own = Sky.ToLight(triangle.Colour);
        Vector3 normal = triangle.Normal;
        if (triangle.Surface == Surface.Ground)
        {
            own *= GrainAt(place, distance);
        }

        own = Snowed(own, triangle.Surface, normal);
        Vector3 light = _ambient * (0.8f + (0.2f * normal.Z));
        light += _sunColour * Math.Max(0, Vector3.Dot(normal, _sun));
        light += _lights.At(place, normal, column, row);
        Vector3 lit = triangle.Surface switch
        {
            Surface.Lamp => own,
            Surface.NightLamp => Vector3.Lerp(own * light, own, _night),
            Surface.LitWindow => Vector3.Lerp(Mirrored(own * light * 0.2f, direction, normal, 0.3f), own, _night),
            Surface.Glass => Mirrored(own * light, direction, normal, 0.3f),
            Surface.Paint => Mirrored(own * light, direction, normal, 0.06f),
            Surface.Ground => Mirrored(own * light * (1 - (0.3f * (float)_lighting.RainFraction)), direction, normal, 0.09f * (float)_lighting.RainFraction),
            _ => own * light,
        };
        float through = MathF.Exp(-(float)_lighting.FogDensity * distance);
        Write(Vector3.Lerp(_sky.Horizon, lit, through), colour);
    }

    /// <summary>The direction in the world whose forward component is 1 m.</summary>
    private Vector3 DirectionAt(int column, int row)
    {
        RenderCamera camera = _view.Camera;
        Vector2D sample = _view.SampleAt(column, row);
        var x = (float)((sample.X - camera.CentreX) / camera.FocalX);
        var y = (float)((sample.Y - camera.CentreY) / camera.FocalY);
        return _forward + (_right * x) - (_up * y);
    }

    /// <summary>Mixes in the mirrored sky, more of it at a grazing angle (Schlick's approximation).</summary>
    private Vector3 Mirrored(Vector3 lit, Vector3 direction, Vector3 normal, float straightOn)
    {
        float cosine = Math.Clamp(-Vector3.Dot(direction, normal), 0, 1);
        float away = 1 - cosine;
        float share = straightOn + ((straightOn > 0 ? 0.5f - (straightOn / 2) : 0) * away * away * away * away);
        return Vector3.Lerp(lit, _sky.GradientAt(Vector3.Reflect(direction, normal)), share);
    }

    private Vector3 Snowed(Vector3 own, Surface surface, Vector3 normal)
    {
        float lying = (float)_lighting.SnowFraction * Math.Clamp((normal.Z - 0.5f) * 2, 0, 1);
        return lying > 0 && surface is Surface.Ground or Surface.Matte or Surface.Paint
            ? Vector3.Lerp(own, new Vector3(0.95f, 0.96f, 1), lying * 0.7f)
            : own;
    }

    /// <summary>A grain on the ground that fades where it would be finer than the pixels.</summary>
    private float GrainAt(Vector3 place, float distance)
    {
        Vector3D eye = _view.Camera.Pose.Position;
        var x = (float)(eye.X + place.X);
        var y = (float)(eye.Y + place.Y);
        float coarse = Noise.At(x * 0.35f, y * 0.35f) - 0.5f;
        float fine = distance < 40 ? (Noise.At(x * 5, y * 5) - 0.5f) * (1 - (distance / 40)) : 0;
        return 1 + (0.10f * coarse) + (0.16f * fine);
    }

    private static void Write(Vector3 light, Span<byte> colour)
    {
        colour[0] = ToByte(light.X);
        colour[1] = ToByte(light.Y);
        colour[2] = ToByte(light.Z);
    }

    private static byte ToByte(float light) => (byte)Math.Clamp((light * 255) + 0.5f, 0, 255);
}
