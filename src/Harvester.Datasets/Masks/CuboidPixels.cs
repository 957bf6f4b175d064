using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Masks;

/// <summary>The pixels whose centres the cuboid of a labelled object covers, with the distance to the cuboid.</summary>
internal sealed class CuboidPixels
{
    /// <summary>
    /// Minimum number of samples: fractions of fewer would be coarse, and a face a few pixels wide may cover no pixel centre.
    /// </summary>
    private const int MinSamples = 16;

    /// <summary>Samples along each side of the box of a smaller cuboid.</summary>
    private const int SamplesAlongSide = 16;

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
                if (DistanceAt(column + 0.5, row + 0.5) is { } distance)
                {
                    Distances.Add((row * image.Width) + column, distance);
                }
            }
        }

        Samples = Distances.Count >= MinSamples ? [.. Distances.Select(pixel => (pixel.Key, pixel.Value))] : [.. FineSamples(label.Box2D)];
    }

    /// <summary>Id of the object.</summary>
    public ushort Id { get; }

    /// <summary>The distance to the cuboid's front, metres, by pixel index.</summary>
    public Dictionary<int, double> Distances { get; } = [];

    /// <summary>
    /// Samples spread evenly over the silhouette: pixel index and distance to the cuboid's front, metres. Empty only for a silhouette of
    /// almost no area.
    /// </summary>
    public IReadOnlyList<(int Pixel, double Distance)> Samples { get; }

    /// <summary>Whether a map has a value anywhere in the silhouette.</summary>
    public bool Shows(InstanceMap map, int number) => Samples.Any(sample => map.Ids[sample.Pixel] == number);

    private IEnumerable<(int Pixel, double Distance)> FineSamples(Box2D box)
    {
        ImageSize image = _camera.Image;
        for (int i = 0; i < SamplesAlongSide * SamplesAlongSide; i++)
        {
            double x = box.XMin + ((i % SamplesAlongSide) + 0.5) / SamplesAlongSide * box.Width;
            double y = box.YMin + ((i / SamplesAlongSide) + 0.5) / SamplesAlongSide * box.Height;
            if (x >= 0 && x < image.Width && y >= 0 && y < image.Height && DistanceAt(x, y) is { } distance)
            {
                yield return (((int)y * image.Width) + (int)x, distance);
            }
        }
    }

    private double? DistanceAt(double x, double y) => _cuboid.Intersect(_camera.RayThrough(x, y))?.Entry;
}
