using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;

namespace Harvester.Geometry.Tests.Scenes;

/// <summary>How well maps agree with exhaustive ones, gathered over scenes, by the objects' true visible pixels.</summary>
internal sealed class MapScores
{
    private readonly List<double> _rayFractions = [];

    /// <summary>Intersection over union of objects of at least 256 visible pixels.</summary>
    public List<double> Large { get; } = [];

    /// <summary>The same of objects of 64 to 256.</summary>
    public List<double> Medium { get; } = [];

    /// <summary>Whether objects of 16 to 64 have a pixel in the map.</summary>
    public List<bool> SmallFound { get; } = [];

    public double MeanRayFraction => _rayFractions.Average();

    /// <summary>The maximum fraction of the rays allowed in a scene, 1.5 times its boundary pixels plus 1,000, that was used.</summary>
    public double MaxFractionOfAllowedRays { get; private set; }

    public void Add(InstanceMap exact, InstanceMap map, int raysCast)
    {
        _rayFractions.Add((double)raysCast / exact.Image.PixelCount);
        MaxFractionOfAllowedRays = Math.Max(MaxFractionOfAllowedRays, raysCast / ((1.5 * BoundaryPixels(exact)) + 1000));
        int[] truth = new int[ushort.MaxValue + 1];
        int[] shown = new int[ushort.MaxValue + 1];
        int[] shared = new int[ushort.MaxValue + 1];
        for (int i = 0; i < exact.Ids.Length; i++)
        {
            truth[exact.Ids[i]]++;
            shown[map.Ids[i]]++;
            shared[exact.Ids[i]] += exact.Ids[i] == map.Ids[i] ? 1 : 0;
        }

        for (int id = 1; id < truth.Length; id++)
        {
            double agreement = (double)shared[id] / Math.Max(1, truth[id] + shown[id] - shared[id]);
            switch (truth[id])
            {
                case >= 256:
                    Large.Add(agreement);
                    break;
                case >= 64:
                    Medium.Add(agreement);
                    break;
                case >= 16:
                    SmallFound.Add(shared[id] > 0);
                    break;
            }
        }
    }

    /// <summary>Pixels with a neighbour, to the side or above or below, of another number.</summary>
    public static int BoundaryPixels(InstanceMap map)
    {
        ImageSize size = map.Image;
        int pixels = 0;
        for (int row = 0; row < size.Height; row++)
        {
            for (int column = 0; column < size.Width; column++)
            {
                ushort id = map[column, row];
                bool isBoundary =
                    (column > 0 && map[column - 1, row] != id)
                    || (column + 1 < size.Width && map[column + 1, row] != id)
                    || (row > 0 && map[column, row - 1] != id)
                    || (row + 1 < size.Height && map[column, row + 1] != id);
                pixels += isBoundary ? 1 : 0;
            }
        }

        return pixels;
    }
}
