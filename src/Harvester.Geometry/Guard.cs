namespace Harvester.Geometry;

/// <summary>Argument checks of the public API; NaN and infinity are rejected there.</summary>
internal static class Guard
{
    public static double Finite(double value, string name)
    {
        if (double.IsNaN(value) || double.IsInfinity(value))
        {
            throw new ArgumentOutOfRangeException(name, value, $"{name} must be a finite number.");
        }

        return value;
    }

    public static double Positive(double value, string name)
    {
        if (Finite(value, name) <= 0)
        {
            throw new ArgumentOutOfRangeException(name, value, $"{name} must be greater than 0.");
        }

        return value;
    }

    public static int AtLeast(int value, int minimum, string name) =>
        value >= minimum
            ? value
            : throw new ArgumentOutOfRangeException(name, value, FormattableString.Invariant($"{name} must be at least {minimum}."));

    public static double InOpenRange(double value, double low, double high, string name)
    {
        if (!(Finite(value, name) > low && value < high))
        {
            throw new ArgumentOutOfRangeException(
                name,
                value,
                FormattableString.Invariant($"{name} must lie between {low} and {high}, both excluded.")
            );
        }

        return value;
    }

    public static Vector3D Finite(Vector3D value, string name)
    {
        if (!value.IsFinite)
        {
            throw new ArgumentOutOfRangeException(name, value, $"{name} must have finite components.");
        }

        return value;
    }

    public static Axes Orientation(Axes value, string name) =>
        value.IsOrientation
            ? value
            : throw new ArgumentException($"{name} must be an orientation, not the default value of the type.", name);

    public static T NotNull<T>(T? value, string name)
        where T : class => value ?? throw new ArgumentNullException(name);
}
