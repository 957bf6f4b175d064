using Harvester.Geometry.Visibility;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;

namespace Harvester.Runs.Tests.Relabelling;

/// <summary>
/// Labels as lines that are the same for the same things, whatever numbers objects have: another harvest may give others. The rays are
/// those of the harvest that was recorded. Everything else stays in, except what a test says that only the game could tell.
/// </summary>
internal static class ComparedLabels
{
    public static string[] Of(
        SessionReader session,
        Func<ObjectLabel, ObjectLabel>? objects = null,
        Func<LanesLabel, LanesLabel>? lanes = null,
        Func<IgnoreRegion, bool>? regions = null
    ) =>
        [
            .. session
                .ReadLabels()
                .Select(label =>
                    JsonLabelWriter.Line(
                        label with
                        {
                            Objects = [.. label.Objects.Select(item => Numberless(objects?.Invoke(item) ?? item)).OrderBy(PlaceOf)],
                            Rays = null,
                            IgnoreRegions = [.. label.IgnoreRegions.Where(regions ?? (_ => true))],
                            Lanes = label.Lanes is { } seen ? Numberless(lanes?.Invoke(seen) ?? seen) : null,
                        }
                    )
                ),
        ];

    public static ObjectLabel WithoutOcclusion(ObjectLabel item) =>
        WithoutVisibleJoints(item) with
        {
            OccludedFraction = null,
            OcclusionMethod = OcclusionMethod.None,
            Box2DVisible = null,
        };

    /// <summary>A label without what rays tell of its joints.</summary>
    public static ObjectLabel WithoutVisibleJoints(ObjectLabel item) =>
        item.Joints is not { } joints
            ? item
            : item with
            {
                Joints = new JointsLabel(
                    [.. joints.Joints.Select(joint => joint with { Visibility = JointVisibility.Unknown })],
                    joints.Box
                ),
            };

    /// <summary>The measured part of the lanes, without what only rays or the game provide: hidden points and paint.</summary>
    public static LanesLabel Measured(LanesLabel lanes) =>
        lanes with
        {
            Markings = null,
            Boundaries =
            [
                .. lanes.Boundaries.Select(line => line with { Points = [.. line.Points.Select(point => point with { IsHidden = null })] }),
            ],
        };

    private static ObjectLabel Numberless(ObjectLabel item) =>
        item with
        {
            Id = 0,
            Parent = item.Parent is null ? null : 0,
            Vehicle = item.Vehicle is null ? null : 0,
        };

    private static LanesLabel Numberless(LanesLabel lanes) =>
        lanes with
        {
            Vehicles = [.. lanes.Vehicles.Select(vehicle => vehicle with { Id = 0 })],
        };

    private static (double X, double Y, double Z, int Face, string Model) PlaceOf(ObjectLabel item) =>
        (item.Box3D.Centre.X, item.Box3D.Centre.Y, item.Box3D.Centre.Z, item.Face?.Number ?? -1, item.Model);
}
