using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Tests.Scenes;
using Harvester.Geometry.Visibility;

namespace Harvester.Benchmarks.PixelMaps;

/// <summary>
/// The pixels of a scene that a strategy has asked for; each costs a ray once, and those outside all objects' boxes cost none.
/// </summary>
internal sealed class SampledImage
{
    private readonly TownScene _scene;
    private readonly int[] _known;

    public SampledImage(TownScene scene, IReadOnlyList<MapTarget> targets)
    {
        _scene = scene;
        Size = scene.Camera.Image;
        _known = new int[Size.PixelCount];
        foreach (MapTarget target in targets)
        {
            if (target.Projection.Box is { } box)
            {
                for (int row = (int)box.YMin; row < box.YMax; row++)
                {
                    for (int column = (int)box.XMin; column < box.XMax; column++)
                    {
                        _known[(row * Size.Width) + column] = -1;
                    }
                }
            }
        }

        Seeds = [.. targets.Select(target => target.Projection.Box).OfType<Box2D>().SelectMany(SeedsOf)];
        foreach ((int column, int row) in Seeds)
        {
            _ = this[column, row];
        }
    }

    public ImageSize Size { get; }

    /// <summary>Asked pixels of the objects' boxes: three of each, so that small objects are not overlooked.</summary>
    public IReadOnlyList<(int Column, int Row)> Seeds { get; }

    public int Rays { get; private set; }

    public bool IsKnown(int column, int row) => _known[(row * Size.Width) + column] >= 0;

    public int this[int column, int row]
    {
        get
        {
            int index = (row * Size.Width) + column;
            if (_known[index] < 0)
            {
                Rays++;
                _known[index] = _scene.Cast(_scene.Camera.RayThrough(column + 0.5, row + 0.5), 10_000, RayHit.World)?.Entity ?? 0;
            }

            return _known[index];
        }
    }

    /// <summary>A map of every pixel as the pixel in the middle of its square of a grid shows it.</summary>
    public InstanceMap Nearest(int step)
    {
        var map = new InstanceMap(Size);
        for (int row = 0; row < Size.Height; row++)
        {
            for (int column = 0; column < Size.Width; column++)
            {
                int c = Math.Min((column / step * step) + (step / 2), Size.Width - 1);
                int r = Math.Min((row / step * step) + (step / 2), Size.Height - 1);
                map[column, row] = (ushort)(IsKnown(column, row) ? this[column, row] : this[c, r]);
            }
        }

        return map;
    }

    /// <summary>A map of what is known, the gaps filled with the last known number to the left.</summary>
    public InstanceMap FillFromTheLeft()
    {
        var map = new InstanceMap(Size);
        for (int row = 0; row < Size.Height; row++)
        {
            int number = 0;
            for (int column = 0; column < Size.Width; column++)
            {
                number = IsKnown(column, row) ? this[column, row] : number;
                map[column, row] = (ushort)number;
            }
        }

        return map;
    }

    private IEnumerable<(int Column, int Row)> SeedsOf(Box2D box)
    {
        foreach ((double across, double down) in new[] { (0.5, 0.5), (0.4, 0.25), (0.6, 0.75) })
        {
            yield return (
                Math.Clamp((int)(box.XMin + (box.Width * across)), 0, Size.Width - 1),
                Math.Clamp((int)(box.YMin + (box.Height * down)), 0, Size.Height - 1)
            );
        }
    }
}
