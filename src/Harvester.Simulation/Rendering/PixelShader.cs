using System.Numerics;
using System.Runtime.Intrinsics;

namespace Harvester.Simulation.Rendering;

/// <summary>Light and air for each pixel, row by row.</summary>
internal sealed class PixelShader
{
    /// <summary>How much of a vehicle's roof and bonnet snow covers, where it covers the ground.</summary>
    private const float SnowOnPaint = 0.5f;

    /// <summary>Where asphalt has no lanes, in junctions, wheels run everywhere, but less.</summary>
    private const float EverywhereInJunctions = 0.4f;

    /// <summary>Snow covers so much of what lies level where lighting and detail are plain.</summary>
    private const float PlainSnow = 0.7f;

    /// <summary>From this amount of snow on, the ground is covered wherever it lies level.</summary>
    private const float FullSnow = 0.75f;

    /// <summary>Haze at the horizon: the fog of this many metres.</summary>
    private const float HazeMetres = 45;

    /// <summary>Share of the sky's light on an upright wall, and how much more or less a surface gets that faces up or down.</summary>
    private const float SkyFromLevel = 0.8f;
    private const float SkyByTilt = 0.2f;

    private static readonly Vector3 Snow = new(0.95f, 0.96f, 1);

    private readonly Lighting _lighting;
    private readonly Sky _sky;
    private readonly LightMap _lights;
    private readonly ViewDirections _directions;
    private readonly GroundLook _ground;
    private readonly Vector3 _sun;
    private readonly Vector3 _sunColour;
    private readonly Vector3 _ambient;
    private readonly float _near;
    private readonly float _night;
    private readonly float _rain;
    private readonly float _fog;
    private readonly float _haze;

    private readonly SceneShadows? _shadows;
    private readonly MarkingLayer? _markings;

    /// <param name="scene">What is drawn.</param>
    /// <param name="view">The camera's view.</param>
    /// <param name="shadows">The scene's shadows; null for none.</param>
    /// <param name="markings">The road markings; null if they are among the triangles.</param>
    public PixelShader(RenderScene scene, View view, SceneShadows? shadows, MarkingLayer? markings)
    {
        (_shadows, _markings) = (shadows, markings);
        _lighting = scene.Lighting;
        _sky = new Sky(_lighting);
        _lights = new LightMap(scene, view);
        _directions = new ViewDirections(view);
        _ground = new GroundLook(view.Camera.Pose.Position, shadows is not null);
        _sun = Sky.ToSingle(_lighting.SunDirection);
        _sunColour = Sky.ToLight(_lighting.SunColour);
        _ambient = Sky.ToLight(_lighting.AmbientColour);
        _near = (float)view.Camera.NearClip;
        _night = (float)_lighting.NightFraction;
        _rain = (float)_lighting.RainFraction;
        _fog = (float)_lighting.FogDensity;
        _haze = Math.Min(1, _fog * HazeMetres);
    }

    /// <summary>Works out depths, directions and air of a row.</summary>
    /// <param name="row">The row, with its number.</param>
    /// <param name="nearness">Near / depth of its pixels; 0 for the sky.</param>
    public void Begin(PixelRow row, ReadOnlySpan<float> nearness)
    {
        _directions.Begin(row);
        nearness.CopyTo(row.Depths);
        for (int column = 0; column < nearness.Length; column += PixelRow.Step)
        {
            Vector256<float> depth = Vector256.Create(_near) / Vector256.Create(row.Depths, column);
            depth.CopyTo(row.Depths, column);

            // Beer and Lambert's law: e^(-density · distance) of the light comes through.
            Wide.Exp(Vector256.Create(-_fog) * depth * Vector256.Create(row.Stretch, column)).CopyTo(row.Through, column);
        }
    }

    /// <summary>Works out where the pixels of a row look, and their depths, as <see cref="WantShadows"/> needs them.</summary>
    /// <param name="row">The row, with its number.</param>
    /// <param name="nearness">Near / depth of its pixels; 0 for the sky.</param>
    public void BeginShadows(PixelRow row, ReadOnlySpan<float> nearness)
    {
        _directions.Begin(row);
        nearness.CopyTo(row.Depths);
        for (int column = 0; column < nearness.Length; column += PixelRow.Step)
        {
            (Vector256.Create(_near) / Vector256.Create(row.Depths, column)).CopyTo(row.Depths, column);
        }
    }

    /// <summary>Asks for the shadows that may lie on pixels of a row that show one triangle.</summary>
    public void WantShadows(in ScreenTriangle triangle, PixelRow row, int first, int length)
    {
        Vector3 normal = triangle.Normal;
        float facing = Math.Max(0, Vector3.Dot(normal, _sun));
        for (int column = first; facing > 0 && column < first + length; column += PixelRow.Step)
        {
            _shadows!.Want(_directions.At(row, column) * Vector256.Create(row.Depths, column), normal, facing);
        }
    }

    /// <summary>Colours pixels of a row that show the sky.</summary>
    public void ShadeSky(PixelRow row, int first, int length)
    {
        WideVector horizon = WideVector.Of(_sky.Horizon);
        for (int column = first; column < first + length; column += PixelRow.Step)
        {
            WideVector direction = _directions.At(row, column) * (Wide.One / Vector256.Create(row.Stretch, column));
            row.Write(column, _sky.ColourAt(direction).Towards(horizon, Vector256.Create(_haze)));
        }
    }

    /// <summary>Colours pixels of a row that show one triangle.</summary>
    public void Shade(in ScreenTriangle triangle, PixelRow row, int first, int length)
    {
        // Everything is relative to the camera, so that single precision is enough anywhere in the world.
        Surface surface = triangle.Surface;
        Vector3 normal = triangle.Normal;
        float lying = SnowOn(surface, normal);
        Vector3 colour = Sky.ToLight(triangle.Colour);

        // Lambert: the sun's light times the cosine of its angle of incidence, and the sky's.
        Vector3 fromSky = _ambient * (SkyFromLevel + (SkyByTilt * normal.Z));
        float facing = Math.Max(0, Vector3.Dot(normal, _sun));
        WideVector light = WideVector.Of(fromSky + (_sunColour * facing));
        WideVector own = WideVector.Of(Vector3.Lerp(colour, Snow, lying));
        WideVector lit = own * light;
        WideVector horizon = WideVector.Of(_sky.Horizon);
        bool isGround = surface is Surface.Ground or Surface.Asphalt;
        bool isMarked = isGround && _markings?.HasAny(row.Number) == true;
        bool needsPlace = isGround || _shadows is not null || _lights.AreLit;
        for (int column = first; column < first + length; column += _lights.StepAt(column))
        {
            WideVector place = default;
            if (needsPlace)
            {
                place = _directions.At(row, column) * Vector256.Create(row.Depths, column);
            }

            if (isGround)
            {
                Vector256<float> tracks =
                    _shadows is null ? Wide.Zero
                    : triangle.Lanes.HasLanes ? triangle.Lanes.TracksAt(place)
                    : Vector256.Create(EverywhereInJunctions);
                Vector256<float> distance = Vector256.Create(row.Depths, column) * Vector256.Create(row.Stretch, column);
                own = WideVector.Of(colour) * _ground.GrainAt(place, distance, surface, tracks);
                own = isMarked ? Marked(own, row.Number, column) : own;
                own = own.Towards(WideVector.Of(Snow), _ground.SnowAt(place, surface, tracks, lying));
                lit = own * light;
            }

            if (_shadows is not null || _lights.AreLit)
            {
                light = _shadows is null ? light : LightAt(place, normal, fromSky, facing);
                lit = own * (_lights.AreLit ? light + _lights.At(place, normal, column, row.Number) : light);
            }

            WideVector shown = surface switch
            {
                Surface.Lamp => own,
                Surface.NightLamp => lit.Towards(own, Vector256.Create(_night)),
                Surface.LitWindow => Mirrored(lit * Vector256.Create(0.2f), row, column, normal, 0.3f)
                    .Towards(own, Vector256.Create(_night)),
                Surface.Glass => Mirrored(lit, row, column, normal, 0.3f),
                Surface.Paint => Mirrored(lit, row, column, normal, 0.06f),
                Surface.Asphalt when _rain > 0 && _shadows is not null => lit * Vector256.Create(1 - (0.4f * _rain)),
                Surface.Ground when _rain > 0 && _shadows is not null => lit * Vector256.Create(1 - (0.2f * _rain)),
                Surface.Ground or Surface.Asphalt when _rain > 0 => Mirrored(
                    lit * Vector256.Create(1 - (0.3f * _rain)),
                    row,
                    column,
                    normal,
                    0.09f * _rain
                ),
                _ => lit,
            };

            // What the air does not let through has the colour of the horizon.
            row.Write(column, horizon.Towards(shown, Vector256.Create(row.Through, column)));
        }
    }

    /// <summary>Paint over asphalt, as far as it covers the pixels.</summary>
    private WideVector Marked(in WideVector asphalt, int row, int column)
    {
        ReadOnlySpan<float> coverage = _markings!.CoverageOf(row)[column..];
        ReadOnlySpan<Rgb> colours = _markings.ColoursOf(row)[column..];
        int count = Math.Min(PixelRow.Step, coverage.Length);
        Span<float> shares = stackalloc float[PixelRow.Step];
        coverage[..count].CopyTo(shares);
        Vector256<float> share = Vector256.Create<float>(shares);
        if (share == Wide.Zero)
        {
            return asphalt;
        }

        Span<float> channels = stackalloc float[3 * PixelRow.Step];
        for (int pixel = 0; pixel < count; pixel++)
        {
            Vector3 paint = Sky.ToLight(colours[pixel]);
            channels[pixel] = paint.X;
            channels[pixel + PixelRow.Step] = paint.Y;
            channels[pixel + (2 * PixelRow.Step)] = paint.Z;
        }

        var painted = new WideVector(
            Vector256.Create<float>(channels),
            Vector256.Create<float>(channels[PixelRow.Step..]),
            Vector256.Create<float>(channels[(2 * PixelRow.Step)..])
        );
        return asphalt.Towards(painted, share);
    }

    /// <summary>The light of sun and sky that shadows leave.</summary>
    private WideVector LightAt(in WideVector place, Vector3 normal, Vector3 fromSky, float facing)
    {
        WideVector light = WideVector.Of(fromSky) * _shadows!.SkyAt(place, normal);
        return facing > 0 && _shadows.AreCast
            ? light + (WideVector.Of(_sunColour * facing) * _shadows.SunAt(place, normal, facing))
            : light + WideVector.Of(_sunColour * facing);
    }

    /// <summary>
    /// Mixes in the mirrored sky, more of it at a grazing angle: F0 + (1 - F0) / 2 · (1 - cos)⁴, after Schlick's F0 + (1 - F0) (1 - cos)⁵
    /// (1994).
    /// </summary>
    private WideVector Mirrored(in WideVector lit, PixelRow row, int column, Vector3 normal, float straightOn)
    {
        WideVector direction = _directions.At(row, column);
        Vector256<float> shrink = Wide.One / Vector256.Create(row.Stretch, column);
        Vector256<float> towards = direction.Dot(WideVector.Of(normal)) * shrink;
        Vector256<float> away = Wide.One - Wide.Fraction(-towards);
        away *= away;
        Vector256<float> share = Vector256.Create(straightOn) + (Vector256.Create(0.5f - (straightOn / 2)) * away * away);

        // Vertical component of the mirrored direction, d - 2 (d · n) n.
        Vector256<float> height = (direction.Z * shrink) - (towards * Vector256.Create(2 * normal.Z));
        return lit.Towards(_sky.GradientAt(height), share);
    }

    /// <summary>How much snow lies on a surface on average, 0 to 1.</summary>
    private float SnowOn(Surface surface, Vector3 normal)
    {
        float level = (float)_lighting.SnowFraction * Math.Clamp((normal.Z - 0.5f) * 2, 0, 1);
        return surface switch
        {
            Surface.Glass or Surface.LitWindow or Surface.NightLamp or Surface.Lamp => 0,
            _ when _shadows is null => level * PlainSnow,
            Surface.Paint => level * SnowOnPaint,
            _ => Math.Min(1, level / FullSnow),
        };
    }
}
