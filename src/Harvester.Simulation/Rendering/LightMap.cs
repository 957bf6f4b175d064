using System.Numerics;
using System.Runtime.Intrinsics;
using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>The lamps that are lit at night, sorted into the tiles of the image that their light can reach.</summary>
internal sealed class LightMap
{
    private const int TileSize = 32;

    /// <summary>However strong lamps are, surfaces do not get brighter than one over this.</summary>
    private const float Exposure = 0.8f;

    private readonly int _tilesAcross;
    private readonly List<NearLight>?[] _tiles = [];
    private readonly float _night;

    public LightMap(RenderScene scene, View view)
    {
        _night = (float)scene.Lighting.NightFraction;
        if (_night <= 0 || scene.Lights.Count == 0)
        {
            return;
        }

        RenderCamera camera = view.Camera;
        _tilesAcross = (camera.Width + TileSize - 1) / TileSize;
        _tiles = new List<NearLight>?[_tilesAcross * ((camera.Height + TileSize - 1) / TileSize)];
        foreach (LightSource light in scene.Lights)
        {
            PixelRectangle reach = ReachOf(light, view);
            for (int row = reach.Top / TileSize; row * TileSize < reach.Bottom; row++)
            {
                for (int column = reach.Left / TileSize; column * TileSize < reach.Right; column++)
                {
                    (_tiles[(row * _tilesAcross) + column] ??= []).Add(new NearLight(light, camera.Pose.Position));
                }
            }
        }
    }

    /// <summary>Whether any lamp lights what is in view.</summary>
    public bool AreLit => _tiles.Length > 0;

    /// <summary>How many pixels from a column on, at most as many as are coloured at once, lie in the same tile.</summary>
    public int StepAt(int column) => AreLit ? Math.Min(PixelRow.Step, TileSize - (column % TileSize)) : PixelRow.Step;

    /// <summary>
    /// The light of all lamps on a surface at places relative to the camera; those past the tile's end get the wrong one.
    /// </summary>
    public WideVector At(in WideVector place, Vector3 normal, int column, int row)
    {
        WideVector light = WideVector.Of(Vector3.Zero);
        foreach (NearLight lamp in _tiles[((row / TileSize) * _tilesAcross) + (column / TileSize)] ?? [])
        {
            light = lamp.Add(light, place, normal);
        }

        // The brightest places of a picture are as bright as a sunny day's, as a camera exposes them.
        Vector256<float> most = Vector256.MaxNative(light.X, Vector256.MaxNative(light.Y, light.Z));
        return light * (Vector256.Create(_night) / (Wide.One + (Vector256.Create(Exposure) * most)));
    }

    /// <summary>The pixels that a lamp may light: those of a sphere around it or, if its cone is narrow, around the cone.</summary>
    private static PixelRectangle ReachOf(LightSource light, View view)
    {
        const double narrow = 0.71;
        RenderCamera camera = view.Camera;
        double range = light.ConeCosine > narrow ? light.RangeMetres / (2 * light.ConeCosine) : light.RangeMetres;
        Vector3D middle = light.ConeCosine > narrow ? light.Position + (light.Direction * range) : light.Position;
        Vector3D centre = camera.Pose.ToLocal(middle);
        double nearest = centre.Y - range;
        double farthest = centre.Y + range;
        if (farthest < camera.NearClip)
        {
            return default;
        }

        if (nearest <= camera.NearClip)
        {
            return new PixelRectangle(0, 0, camera.Width, camera.Height);
        }

        // The box around the sphere, projected at its nearest and its farthest depth, contains the sphere's image.
        double left = Math.Min((centre.X - range) / nearest, (centre.X - range) / farthest);
        double right = Math.Max((centre.X + range) / nearest, (centre.X + range) / farthest);
        double low = Math.Min((centre.Z - range) / nearest, (centre.Z - range) / farthest);
        double high = Math.Max((centre.Z + range) / nearest, (centre.Z + range) / farthest);
        return view.PixelsIn(
            camera.CentreX + (camera.FocalX * left),
            camera.CentreY - (camera.FocalY * high),
            camera.CentreX + (camera.FocalX * right),
            camera.CentreY - (camera.FocalY * low)
        );
    }

    private readonly struct NearLight(LightSource light, Vector3D eye)
    {
        private readonly Vector3 _place = Sky.ToSingle(light.Position - eye);
        private readonly Vector3 _direction = Sky.ToSingle(light.Direction);
        private readonly Vector3 _colour = Sky.ToLight(light.Colour) * (float)light.Strength;
        private readonly float _grazing = (float)light.GrazingFraction;
        private readonly float _cone = (float)light.ConeCosine;
        private readonly float _range = (float)light.RangeMetres;
        private readonly float _nearest = (float)Math.Max(0.01, light.NearestMetres);

        public WideVector Add(in WideVector light, in WideVector place, Vector3 normal)
        {
            WideVector towards = WideVector.Of(_place) - place;
            Vector256<float> distance = Vector256.Sqrt(towards.Dot(towards));

            // Strength (1 - distance / range)², 0 from the range on; it is weaker near the lamp, within the nearest distance.
            Vector256<float> fade = Wide.One - (distance * Vector256.Create(1 / _range));
            Vector256<float> isLit = Vector256.GreaterThan(fade, Wide.Zero) & Vector256.GreaterThan(distance, Wide.Zero);
            if (isLit == Wide.Zero)
            {
                return light;
            }

            towards *= Wide.One / distance;
            Vector256<float> inCone = Wide.Fraction(
                (-towards.Dot(WideVector.Of(_direction)) - Vector256.Create(_cone)) * Vector256.Create(2.5f / (1 - _cone))
            );
            if ((isLit & inCone) == Wide.Zero)
            {
                return light;
            }

            Vector256<float> facing =
                Vector256.Create(_grazing)
                + (Vector256.Create(1 - _grazing) * Vector256.MaxNative(towards.Dot(WideVector.Of(normal)), Wide.Zero));
            return light
                + (
                    WideVector.Of(_colour)
                    * (isLit & (inCone * facing * fade * fade * Wide.Fraction(distance * Vector256.Create(1 / _nearest))))
                );
        }
    }
}
