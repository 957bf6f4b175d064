using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Exports.Formats.NuScenes;

/// <summary>Names of nuScenes, and how classes relate to its categories; docs/exports/nuscenes.md has the table.</summary>
internal static class NuScenesClasses
{
    private const string Car = "vehicle.car";
    private const string Police = "vehicle.emergency.police";
    private const string Ambulance = "vehicle.emergency.ambulance";

    /// <summary>The category of points without a class.</summary>
    public const string Noise = "noise";

    /// <summary>The index of the first category of stuff, which has no instances; those of things are less, and greater than 0.</summary>
    public const int FirstStuff = 24;

    /// <summary>The categories that are used, with the index that nuScenes-lidarseg has for each, in its order.</summary>
    public static IReadOnlyList<(string Name, int Index)> Categories { get; } =
    [
        (Noise, 0),
        ("human.pedestrian.adult", 2),
        ("vehicle.bicycle", 14),
        ("vehicle.bus.rigid", 16),
        (Car, 17),
        (Ambulance, 19),
        (Police, 20),
        ("vehicle.motorcycle", 21),
        ("vehicle.trailer", 22),
        ("vehicle.truck", 23),
        ("flat.driveable_surface", FirstStuff),
        ("flat.other", 25),
        ("flat.sidewalk", 26),
        ("flat.terrain", 27),
        ("static.manmade", 28),
        ("static.other", 29),
        ("static.vegetation", 30),
    ];

    /// <summary>All attributes of nuScenes.</summary>
    public static IReadOnlyList<string> Attributes { get; } =
    [
        "vehicle.moving",
        "vehicle.stopped",
        "vehicle.parked",
        "cycle.with_rider",
        "cycle.without_rider",
        "pedestrian.sitting_lying_down",
        "pedestrian.standing",
        "pedestrian.moving",
    ];

    /// <summary>The levels of visibility with the fraction from which each begins; their tokens are 1 to 4.</summary>
    public static IReadOnlyList<(string Level, double From)> Visibilities { get; } =
    [("v0-40", 0), ("v40-60", 0.4), ("v60-80", 0.6), ("v80-100", 0.8)];

    /// <summary>The index of a category.</summary>
    public static int IndexOf(string category) => Categories.First(each => each.Name == category).Index;

    /// <summary>The category of an object; null if nuScenes does not annotate it. Riders belong to their vehicles.</summary>
    public static string? CategoryOf(ObjectLabel label) => label.Parent is not null ? null : CategoryOf(label.Class, label.Model);

    /// <summary>The category of an entity; null if nuScenes does not annotate it. Riders belong to their vehicles.</summary>
    public static string? CategoryOf(ObjectClass kind, string model) =>
        kind switch
        {
            ObjectClass.Rider => null,
            ObjectClass.Pedestrian => "human.pedestrian.adult",
            ObjectClass.Bicycle => "vehicle.bicycle",
            ObjectClass.Bus => "vehicle.bus.rigid",
            ObjectClass.Motorcycle => "vehicle.motorcycle",
            ObjectClass.Trailer => "vehicle.trailer",
            _ when model.StartsWith("police", StringComparison.Ordinal) => Police,
            _ when model.StartsWith("ambulance", StringComparison.Ordinal) => Ambulance,
            ObjectClass.Car => Car,
            ObjectClass.Truck => "vehicle.truck",
            _ => null,
        };

    /// <summary>The attribute of an object; null if it has none.</summary>
    /// <param name="category">Its category.</param>
    /// <param name="isMoving">Whether it moves now.</param>
    /// <param name="everMoves">Whether it moves at any time of its scene; a vehicle that never does counts as parked.</param>
    /// <param name="hasRider">Whether somebody sits on a motorcycle or bicycle; null if unknown.</param>
    public static string? AttributeOf(string category, bool isMoving, bool everMoves, bool? hasRider) =>
        category switch
        {
            "human.pedestrian.adult" => isMoving ? "pedestrian.moving" : "pedestrian.standing",
            "vehicle.bicycle" or "vehicle.motorcycle" => hasRider switch
            {
                true => "cycle.with_rider",
                false => "cycle.without_rider",
                null => null,
            },
            _ => isMoving ? "vehicle.moving"
            : everMoves ? "vehicle.stopped"
            : "vehicle.parked",
        };

    /// <summary>The token of the level of a visible fraction.</summary>
    public static string VisibilityOf(double fraction)
    {
        int level = 1;
        while (level < Visibilities.Count && fraction >= Visibilities[level].From)
        {
            level++;
        }

        return Numbers.Text(level);
    }
}
