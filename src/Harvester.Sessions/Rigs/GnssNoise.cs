using Harvester.Sessions.Text;

namespace Harvester.Sessions.Rigs;

/// <summary>
/// The errors of a satellite receiver: white noise of each sample, and a bias of the position that walks from zero. The same seed gives the
/// same errors.
/// </summary>
/// <exception cref="ArgumentOutOfRangeException">A value is negative or not a number.</exception>
public sealed record GnssNoise
{
    /// <summary>The names of the values as text.</summary>
    public const string Form = "horizontal=N, vertical=N, horizontalWalk=N, verticalWalk=N and velocity=N";

    /// <summary>The greatest values as text.</summary>
    public const string Limits = "at most 100, 100, 1, 1 and 10";

    /// <summary>Decimals of the values in files.</summary>
    internal const int Decimals = 6;

    private const double MaxMetres = 100;
    private const double MaxWalk = 1;
    private const double MaxVelocity = 10;

    /// <summary>Standard deviation of the position to the east and to the north, metres; 0 or more.</summary>
    public double Horizontal
    {
        get;
        init => field = OptionCheck.AtLeast(value, 0, nameof(Horizontal));
    }

    /// <summary>Standard deviation of the altitude, metres; 0 or more.</summary>
    public double Vertical
    {
        get;
        init => field = OptionCheck.AtLeast(value, 0, nameof(Vertical));
    }

    /// <summary>Random walk of the bias to the east and to the north, m/√s; 0 or more.</summary>
    public double HorizontalWalk
    {
        get;
        init => field = OptionCheck.AtLeast(value, 0, nameof(HorizontalWalk));
    }

    /// <summary>Random walk of the bias of the altitude, m/√s; 0 or more.</summary>
    public double VerticalWalk
    {
        get;
        init => field = OptionCheck.AtLeast(value, 0, nameof(VerticalWalk));
    }

    /// <summary>Standard deviation of each component of the velocity, m/s; 0 or more.</summary>
    public double Velocity
    {
        get;
        init => field = OptionCheck.AtLeast(value, 0, nameof(Velocity));
    }

    /// <summary>Random seed.</summary>
    public int Seed { get; init; }

    /// <summary>The values in a text: a list such as <c>horizontal=1.5,vertical=3</c>, of which those that are missing are 0.</summary>
    /// <param name="text">The text.</param>
    /// <returns>The values with the seed 0; null if the text is no such list.</returns>
    public static GnssNoise? Parse(string text) => NoiseText.Parse(text, new GnssNoise(), With, static (_, _) => null);

    private static GnssNoise? With(GnssNoise noise, string name, double value) =>
        name switch
        {
            "horizontal" when value <= MaxMetres => noise with { Horizontal = value },
            "vertical" when value <= MaxMetres => noise with { Vertical = value },
            "horizontalWalk" when value <= MaxWalk => noise with { HorizontalWalk = value },
            "verticalWalk" when value <= MaxWalk => noise with { VerticalWalk = value },
            "velocity" when value <= MaxVelocity => noise with { Velocity = value },
            _ => null,
        };
}
