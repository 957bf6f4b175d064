using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>
/// How well masks from rays agree with those from photographs, over the frames of a harvest: how good the collision hulls of a game are.
/// </summary>
public sealed class MaskComparison
{
    /// <summary>Objects with fewer pixels in the mask from photographs are not compared.</summary>
    private const int MinPixels = 64;

    private readonly SortedDictionary<ObjectClass, (int Count, double Sum)> _classes = [];

    /// <summary>Number of objects and mean intersection over union of each class with objects of at least 64 pixels.</summary>
    public IReadOnlyList<MaskAgreement> Classes =>
        [.. _classes.Select(each => new MaskAgreement(each.Key, each.Value.Count, each.Value.Sum / each.Value.Count))];

    /// <summary>Pixels at which the masks differ.</summary>
    public long DifferentPixels { get; private set; }

    /// <summary>Pixels at which at least one of the masks has an object.</summary>
    public long ObjectPixels { get; private set; }

    /// <summary>Adds a frame.</summary>
    /// <param name="candidates">The objects; numbers in the maps are their positions from 1.</param>
    /// <param name="coded">The map from photographs.</param>
    /// <param name="rays">The map from rays.</param>
    internal void Add(IReadOnlyList<LabelCandidate> candidates, InstanceMap coded, InstanceMap rays)
    {
        var pixels = new (int Coded, int Rays, int Shared)[candidates.Count + 1];
        for (int i = 0; i < coded.Ids.Length; i++)
        {
            (ushort a, ushort b) = (coded.Ids[i], rays.Ids[i]);
            pixels[a].Coded++;
            pixels[b].Rays++;
            pixels[a].Shared += a == b ? 1 : 0;
            ObjectPixels += a != 0 || b != 0 ? 1 : 0;
            DifferentPixels += a != b ? 1 : 0;
        }

        for (int number = 1; number < pixels.Length; number++)
        {
            (int inCoded, int inRays, int shared) = pixels[number];
            if (inCoded >= MinPixels)
            {
                ObjectClass of = candidates[number - 1].Entity.Class;
                (int count, double sum) = _classes.TryGetValue(of, out (int, double) known) ? known : (0, 0);
                _classes[of] = (count + 1, sum + ((double)shared / (inCoded + inRays - shared)));
            }
        }
    }
}
