using Harvester.Sessions.Scenes;

namespace Harvester.Exports.Formats.MotChallenge;

/// <summary>The numbers of MOT17's classes; docs/exports/motchallenge.md has the table.</summary>
internal static class MotClasses
{
    /// <summary>The only class that is evaluated.</summary>
    public const int Pedestrian = 1;

    /// <summary>What a tracker may or may not follow: its boxes there are not counted.</summary>
    public const int Distractor = 8;

    /// <summary>The greatest number of a class.</summary>
    public const int Last = 12;

    private const int PersonOnVehicle = 2;
    private const int Car = 3;
    private const int Bicycle = 4;
    private const int Motorbike = 5;
    private const int NonMotorisedVehicle = 6;

    /// <summary>The number of a class; null if MOT17 does not label it.</summary>
    public static int? Of(ObjectClass kind) =>
        kind switch
        {
            ObjectClass.Pedestrian => Pedestrian,
            ObjectClass.Rider => PersonOnVehicle,
            ObjectClass.Car or ObjectClass.Truck or ObjectClass.Bus => Car,
            ObjectClass.Bicycle => Bicycle,
            ObjectClass.Motorcycle => Motorbike,
            ObjectClass.Trailer => NonMotorisedVehicle,
            _ => null,
        };
}
