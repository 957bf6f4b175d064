using Harvester.Sessions.Text;

namespace Harvester.Sessions.Rigs;

/// <summary>
/// The errors of an inertial unit, in the terms of data sheets and of Kalibr: white noise, and a bias that walks from zero. The same seed
/// gives the same errors.
/// </summary>
/// <exception cref="ArgumentOutOfRangeException">A value is negative or not a number.</exception>
public sealed record ImuNoise
{
    /// <summary>The names of the values as text.</summary>
    public const string Form = "gyro=N, gyroWalk=N, accel=N and accelWalk=N";

    /// <summary>
    /// The greatest values as text, hundreds of times those of the worst units: what such a unit measures is still within what
    /// harvester validate takes for a vehicle.
    /// </summary>
    public const string Limits = "at most 1, 0.1, 10 and 10";

    /// <summary>The name of a predefined unit.</summary>
    public const string Adis16448 = "adis16448";

    /// <summary>Decimals of the values in files.</summary>
    internal const int Decimals = 9;

    /// <summary>Noise density of the angular rate, rad/s/√Hz; 0 or more.</summary>
    public double Gyroscope
    {
        get;
        init => field = OptionCheck.AtLeast(value, 0, nameof(Gyroscope));
    }

    /// <summary>Random walk of the bias of the angular rate, rad/s²/√Hz; 0 or more.</summary>
    public double GyroscopeWalk
    {
        get;
        init => field = OptionCheck.AtLeast(value, 0, nameof(GyroscopeWalk));
    }

    /// <summary>Noise density of the specific force, m/s²/√Hz; 0 or more.</summary>
    public double Accelerometer
    {
        get;
        init => field = OptionCheck.AtLeast(value, 0, nameof(Accelerometer));
    }

    /// <summary>Random walk of the bias of the specific force, m/s³/√Hz; 0 or more.</summary>
    public double AccelerometerWalk
    {
        get;
        init => field = OptionCheck.AtLeast(value, 0, nameof(AccelerometerWalk));
    }

    /// <summary>Random seed.</summary>
    public int Seed { get; init; }

    /// <summary>
    /// The values in a text: a list such as <c>gyro=1.7e-4,accel=2e-3</c>, of which those that are missing are 0. The name of a unit in the
    /// list stands for its values.
    /// </summary>
    /// <param name="text">The text.</param>
    /// <returns>The values with the seed 0; null if the text is no such list.</returns>
    public static ImuNoise? Parse(string text) => NoiseText.Parse(text, new ImuNoise(), With, WithUnit);

    /// <summary>The values in imu0/sensor.yaml of the EuRoC datasets (Burri et al., IJRR 2016).</summary>
    private static ImuNoise? WithUnit(ImuNoise noise, string name) =>
        name == Adis16448
            ? noise with
            {
                Gyroscope = 1.6968e-4,
                GyroscopeWalk = 1.9393e-5,
                Accelerometer = 2e-3,
                AccelerometerWalk = 3e-3,
            }
            : null;

    private static ImuNoise? With(ImuNoise noise, string name, double value) =>
        name switch
        {
            "gyro" when value <= 1 => noise with { Gyroscope = value },
            "gyroWalk" when value <= 0.1 => noise with { GyroscopeWalk = value },
            "accel" when value <= 10 => noise with { Accelerometer = value },
            "accelWalk" when value <= 10 => noise with { AccelerometerWalk = value },
            _ => null,
        };
}
