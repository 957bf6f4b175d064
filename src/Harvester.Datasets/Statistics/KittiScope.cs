using Harvester.Sessions.Scenes;

namespace Harvester.Datasets.Statistics;

/// <summary>Which objects KITTI labels, so that counts of labels can be compared with its own.</summary>
internal static class KittiScope
{
    /// <summary>Whether KITTI labels objects of a class. Riders belong to their vehicles.</summary>
    public static bool Has(ObjectClass kind) => kind is not (ObjectClass.Sign or ObjectClass.TrafficLight or ObjectClass.Rider);
}
