using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;

namespace Harvester.Runs.Tests.Relabelling;

/// <summary>Parts of labels that the tests of relabelling compare.</summary>
internal static class LabelContent
{
    public static HashSet<IgnoreRegion> Seen(FrameLabel label) =>
        [.. label.IgnoreRegions.Where(region => region.Reason == IgnoreReason.BeyondRange)];

    public static bool IsBeyondBoth(IgnoreRegion region) => region.DistanceMetres > 155;

    // A light's state is read from the picture within its box where it is known to be in sight, which only rays tell.
    public static ObjectLabel Unlit(ObjectLabel item) =>
        item.Face?.Light is null ? item : item with { Face = item.Face with { Light = LightLabel.Unknown } };

    public static IEnumerable<LaneLinePoint> Points(FrameLabel label) => label.Lanes?.Boundaries.SelectMany(line => line.Points) ?? [];

    public static IEnumerable<LaneLinePoint> Paint(FrameLabel label) => label.Lanes?.Markings?.SelectMany(line => line.Points) ?? [];

    public static HashSet<Vector3D> Places(FrameLabel label) => [.. label.Objects.Select(item => item.Box3D.Centre)];

    public static Dictionary<int, string> Models(SessionReader session) =>
        session
            .ReadLabels()
            .SelectMany(label => label.Objects)
            .DistinctBy(item => item.Id)
            .ToDictionary(item => item.Id, item => item.Model);
}
