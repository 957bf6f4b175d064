using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Events;

/// <summary>The impulse of a collision from the changes of velocity and the masses that the classes usually have, N·s.</summary>
/// <param name="Usual">With the usual masses.</param>
/// <param name="Min">The least that masses of the classes allow.</param>
/// <param name="Max">The greatest that masses of the classes allow.</param>
internal readonly record struct ImpulseEstimate(double Usual, double Min, double Max)
{
    /// <summary>Estimates an impulse. Both participants have the same one, each its mass times its change of velocity.</summary>
    public static ImpulseEstimate Of(ObjectClass first, double firstChange, ObjectClass second, double secondChange)
    {
        (double Usual, double Min, double Max) a = Masses(first);
        (double Usual, double Min, double Max) b = Masses(second);
        double min = Math.Max(a.Min * firstChange, b.Min * secondChange);
        double max = Math.Min(a.Max * firstChange, b.Max * secondChange);
        if (min > max)
        {
            // The two estimates contradict each other, as when one also brakes or the body is fixed: all between them is possible.
            min = Math.Min(a.Min * firstChange, b.Min * secondChange);
            max = Math.Max(a.Max * firstChange, b.Max * secondChange);
        }

        // Geometric mean of the two estimates: masses are known by factors.
        double usual = Math.Sqrt(a.Usual * firstChange * b.Usual * secondChange);
        return new ImpulseEstimate(Math.Max(min, Math.Min(max, usual)), min, max);
    }

    /// <summary>
    /// Mass of a class, kg: usual, least, greatest. Vehicles from an empty small one to the greatest permitted laden weight of Directive
    /// 96/53/EC; two-wheelers with a rider; people from a child to a heavy adult.
    /// </summary>
    private static (double Usual, double Min, double Max) Masses(ObjectClass kind) =>
        kind switch
        {
            ObjectClass.Car => (1_500, 700, 3_500),
            ObjectClass.Truck => (10_000, 3_500, 40_000),
            ObjectClass.Bus => (12_000, 5_000, 26_000),
            ObjectClass.Motorcycle => (280, 150, 500),
            ObjectClass.Bicycle => (90, 40, 150),
            ObjectClass.Trailer => (5_000, 300, 36_000),
            ObjectClass.Pedestrian or ObjectClass.Rider => (75, 20, 150),
            _ => (500, 10, 40_000),
        };
}
