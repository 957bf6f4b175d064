using Harvester.Exports;
using Harvester.Exports.Formats.Kitti;
using Harvester.Exports.Formats.NuScenes;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Text;

namespace Harvester.Reports.Comparison;

/// <summary>In whose terms a session is compared: which objects count, their classes and levels of occlusion.</summary>
internal sealed class ClassScheme
{
    private const string Undetermined = "not determined";
    private static readonly string[] KittiLevels = ["0, fully visible", "1, partly occluded", "2, largely occluded", "3, unknown"];
    private static readonly Dictionary<Harvester.Sessions.Scenes.ObjectClass, string> NoNames = [];

    private readonly Func<ObjectLabel, string?> _classOf;
    private readonly Func<ObjectLabel, string> _levelOf;
    private readonly bool _joinsRiders;

    private ClassScheme(Func<ObjectLabel, string?> classOf, Func<ObjectLabel, string> levelOf, bool joinsRiders)
    {
        _joinsRiders = joinsRiders;
        _classOf = classOf;
        _levelOf = levelOf;
    }

    /// <summary>The classes of sessions, with KITTI's levels of occlusion.</summary>
    public static ClassScheme Session { get; } =
        new(label => JsonName.Of(label.Class), label => LevelOfKitti(KittiClasses.OcclusionOf(label)), joinsRiders: false);

    /// <summary>KITTI's types, as its export has them.</summary>
    public static ClassScheme Kitti { get; } = new(TypeOf, label => LevelOfKitti(KittiClasses.OcclusionOf(label)), joinsRiders: true);

    /// <summary>nuScenes' categories, as its export has them, with its levels of visibility.</summary>
    public static ClassScheme NuScenes { get; } =
        new(
            NuScenesClasses.CategoryOf,
            label => label.OccludedFraction is { } hidden ? LevelOfNuScenes(NuScenesClasses.VisibilityOf(1 - hidden)) : Undetermined,
            joinsRiders: true
        );

    /// <summary>KITTI's type of an object; null if it does not label it.</summary>
    public static string? TypeOf(ObjectLabel label) =>
        label.Parent is null && KittiClasses.Has(label.Class) ? KittiClasses.TypeOf(label, NoNames) : null;

    /// <summary>The objects of a frame: with a two-wheeler and its rider as one where the scheme has them so.</summary>
    public IEnumerable<ObjectLabel> ObjectsOf(FrameLabel frame) =>
        _joinsRiders ? RiddenVehicles.WithRiders(frame.Objects, frame.Camera) : frame.Objects;

    /// <summary>The class of an object; null if it does not count.</summary>
    public string? ClassOf(ObjectLabel label) => _classOf(label);

    /// <summary>The level of occlusion or visibility of an object.</summary>
    public string LevelOf(ObjectLabel label) => _levelOf(label);

    /// <summary>The name of KITTI's level; 3 for any other number.</summary>
    public static string LevelOfKitti(double level) => KittiLevels[level is 0 or 1 or 2 ? (int)level : KittiLevels.Length - 1];

    /// <summary>The name of a level of visibility of nuScenes, by its token.</summary>
    public static string LevelOfNuScenes(string token) =>
        int.TryParse(token, out int level) && level >= 1 && level <= NuScenesClasses.Visibilities.Count
            ? NuScenesClasses.Visibilities[level - 1].Level
            : Undetermined;
}
