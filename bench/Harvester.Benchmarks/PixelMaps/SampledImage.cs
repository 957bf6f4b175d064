using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Tests.Scenes;
using Harvester.Geometry.Visibility;

namespace Harvester.Benchmarks.PixelMaps;

/// <summary>The pixels of a scene that a strategy has asked for; each costs a ray once, and those outside all objects' boxes cost none.</summary>
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
    }

    public ImageSize Size { get; }

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
}
