using System.Globalization;

namespace Harvester.Geometry.Lanes;

/// <summary>The distance ahead of the car at which the road is measured. People look about one second ahead.</summary>
public readonly record struct LookAhead
{
    private readonly double _metres;
    private readonly double _seconds;

    private LookAhead(double metres, double seconds)
    {
        _metres = metres;
        _seconds = seconds;
    }

    /// <summary>At the car itself.</summary>
    public static LookAhead AtCar => default;

    /// <summary>Ten metres, as in the thesis.</summary>
    public static LookAhead Thesis { get; } = OfMetres(10);

    /// <summary>A fixed distance, metres, whatever the speed.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not finite or negative.</exception>
    public static LookAhead OfMetres(double metres) => new(NotNegative(metres, nameof(metres)), 0);

    /// <summary>The distance travelled in a number of seconds at the car's speed.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not finite or negative.</exception>
    public static LookAhead OfSeconds(double seconds) => new(0, NotNegative(seconds, nameof(seconds)));

    /// <summary>The distance at a speed in metres per second.</summary>
    public double DistanceAt(double speed) => _metres + (_seconds * Math.Abs(speed));

    /// <summary>Metres, or seconds with an s, in the invariant culture.</summary>
    public override string ToString() =>
        _seconds > 0 ? FormattableString.Invariant($"{_seconds}s") : FormattableString.Invariant($"{_metres}");

    /// <summary>Parses the text that <see cref="ToString"/> writes; null for other text.</summary>
    public static LookAhead? Parse(string text)
    {
        Guard.NotNull(text, nameof(text));
        bool isTime = text.EndsWith("s", StringComparison.Ordinal);
        return !double.TryParse(
                isTime ? text.Substring(0, text.Length - 1) : text,
                NumberStyles.Float,
                CultureInfo.InvariantCulture,
                out double value
            )
            || !(value >= 0)
            || double.IsInfinity(value)
                ? null
            : isTime ? OfSeconds(value)
            : OfMetres(value);
    }

    private static double NotNegative(double value, string name) =>
        Guard.Finite(value, name) >= 0 ? value : throw new ArgumentOutOfRangeException(name, value, $"{name} must be 0 or more.");
}
