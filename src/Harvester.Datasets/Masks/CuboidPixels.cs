using System;
using System.Collections.Generic;
using Harvester.Capture.Labels;
using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;

namespace Harvester.Datasets.Masks;

/// <summary>The pixels of an image at whose centres the cuboid of a labelled object is, and how far away it is there.</summary>
internal sealed class CuboidPixels
{
    private readonly Camera _camera;
    private readonly Cuboid _cuboid;

    public CuboidPixels(Camera camera, ObjectLabel label)
    {
        _camera = camera;
        _cuboid = label.Box3D;
        Id = (ushort)label.Id;
        ImageSize image = camera.Image;
        for (int row = Math.Max(0, (int)label.Box2D.YMin); row < Math.Min(image.Height, label.Box2D.YMax); row++)
        {
            for (int column = Math.Max(0, (int)label.Box2D.XMin); column < Math.Min(image.Width, label.Box2D.XMax); column++)
            {
                int index = (row * image.Width) + column;
                if (DistanceAt(index) is { } distance)
                {
                    Distances.Add(index, distance);
                }
            }
        }
    }

    /// <summary>The object's number.</summary>
    public ushort Id { get; }

    /// <summary>For each pixel, by its place in the image, the distance to the cuboid's front, metres.</summary>
    public Dictionary<int, double> Distances { get; } = [];

    private double? DistanceAt(int index)
    {
        int width = _camera.Image.Width;
        Ray ray = _camera.RayThrough((index % width) + 0.5, (index / width) + 0.5);
        return _cuboid.Intersect(ray)?.Entry;
    }
}
