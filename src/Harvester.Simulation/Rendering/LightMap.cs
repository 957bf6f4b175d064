using System;
using System.Collections.Generic;
using System.Numerics;
using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>The lamps that burn at night, sorted into tiles of the image that their light can reach.</summary>
internal sealed class LightMap
{
    private const int TileSize = 32;
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

    /// <summary>Whether any lamp shines on what is in view.</summary>
    public bool AreLit => _tiles.Length > 0;

    /// <summary>The light of all lamps on a surface at a place relative to the camera.</summary>
    public Vector3 At(Vector3 place, Vector3 normal, int column, int row)
    {
        Vector3 light = Vector3.Zero;
        if (_tiles[((row / TileSize) * _tilesAcross) + (column / TileSize)] is not { } lamps)
        {
            return light;
        }

        foreach (NearLight lamp in lamps)
        {
            light += lamp.At(place, normal);
        }

        return light * _night;
    }

    /// <summary>The pixels that the ball of a lamp's light may cover.</summary>
    private static PixelRectangle ReachOf(LightSource light, View view)
    {
        RenderCamera camera = view.Camera;
        Vector3D centre = camera.Pose.ToLocal(light.Position);
        double nearest = centre.Y - light.RangeMetres;
        if (centre.Y + light.RangeMetres < camera.NearClip)
        {
            return default;
        }

        if (nearest <= camera.NearClip)
        {
            return new PixelRectangle(0, 0, camera.Width, camera.Height);
        }

        double left = Math.Min((centre.X - light.RangeMetres) / nearest, (centre.X - light.RangeMetres) / (centre.Y + light.RangeMetres));
        double right = Math.Max((centre.X + light.RangeMetres) / nearest, (centre.X + light.RangeMetres) / (centre.Y + light.RangeMetres));
        double low = Math.Min((centre.Z - light.RangeMetres) / nearest, (centre.Z - light.RangeMetres) / (centre.Y + light.RangeMetres));
        double high = Math.Max((centre.Z + light.RangeMetres) / nearest, (centre.Z + light.RangeMetres) / (centre.Y + light.RangeMetres));
        return view.PixelsIn(
            camera.CentreX + (camera.FocalX * left),
            camera.CentreY - (camera.FocalY * high),
            camera.CentreX + (camera.FocalX * right),
            camera.CentreY - (camera.FocalY * low));
    }

    private readonly struct NearLight(LightSource light, Vector3D eye)
    {
        private readonly Vector3 _place = Sky.ToSingle(light.Position - eye);
        private readonly Vector3 _direction = Sky.ToSingle(light.Direction);
        private readonly Vector3 _colour = Sky.ToLight(light.Colour);
        private readonly float _cone = (float)light.ConeCosine;
        private readonly float _range = (float)light.RangeMetres;

        public Vector3 At(Vector3 place, Vector3 normal)
        {
            Vector3 towards = _place - place;
            float distance = towards.Length();
            if (distance >= _range || distance == 0)
            {
                return Vector3.Zero;
            }

            towards /= distance;
            float inCone = Math.Clamp((-Vector3.Dot(towards, _direction) - _cone) / (1 - _cone) * 2.5f, 0, 1);
            float facing = 0.25f + (0.75f * Math.Max(0, Vector3.Dot(towards, normal)));
            float fade = 1 - (distance / _range);
            return _colour * (1.6f * inCone * facing * fade * fade);
        }
    }
}
