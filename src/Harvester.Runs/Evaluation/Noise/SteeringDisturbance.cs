using Harvester.Capture.Ports;

namespace Harvester.Runs.Evaluation.Noise;

/// <summary>
/// Pushes the steering of a car aside now and then for a second or two, so that a recorded driver is seen to correct what it would never do
/// itself. The push grows and decays linearly, and its size is a sideways acceleration, so that it does the same at every speed.
/// </summary>
public sealed class SteeringDisturbance
{
    private const double MinPauseSeconds = 3;
    private const double MaxPauseSeconds = 9;
    private const double MinPushSeconds = 0.8;
    private const double MaxPushSeconds = 2;

    /// <summary>Range of the greatest sideways acceleration of a push, m/s².</summary>
    private const double MinPush = 1;
    private const double MaxPush = 2.5;

    /// <summary>Maximum push of the steering wheel, as a fraction of its lock.</summary>
    private const double MaxSteering = 0.25;

    /// <summary>A slower car is not pushed, m/s.</summary>
    private const double MinSpeed = 3;

    private readonly CarTraits _car;
    private readonly Random _random;
    private double _pauseSeconds;
    private double _pushSeconds;
    private double _pushedSeconds;
    private double _push;

    /// <summary>Creates the pushes of a drive.</summary>
    /// <param name="seed">Random seed.</param>
    /// <param name="car">The driven car.</param>
    /// <exception cref="ArgumentNullException"><paramref name="car"/> is null.</exception>
    public SteeringDisturbance(int seed, CarTraits car)
    {
        ArgumentNullException.ThrowIfNull(car);
        _car = car;
        _random = new Random(seed);
        Draw();
    }

    /// <summary>What is added to the steering in the next tick, -1 to 1, positive to the left; 0 between two pushes.</summary>
    /// <param name="speedMetresPerSecond">Speed of the car, m/s.</param>
    /// <param name="seconds">Game time of the tick, seconds; greater than 0.</param>
    public double Next(double speedMetresPerSecond, double seconds)
    {
        if (_pauseSeconds > 0)
        {
            _pauseSeconds -= seconds;
            return 0;
        }

        _pushedSeconds += seconds;
        if (_pushedSeconds >= _pushSeconds)
        {
            Draw();
            return 0;
        }

        double share = 1 - Math.Abs((2 * _pushedSeconds / _pushSeconds) - 1);
        return speedMetresPerSecond < MinSpeed ? 0 : SteeringOf(_push * share, speedMetresPerSecond);
    }

    private double SteeringOf(double acceleration, double speed)
    {
        double ratio = speed / _car.CharacteristicSpeed;
        double wheelAngle = acceleration * _car.Wheelbase * (1 + (ratio * ratio)) / (speed * speed);
        return Math.Clamp(wheelAngle / _car.SteeringLockRadians, -MaxSteering, MaxSteering);
    }

    private void Draw()
    {
        _pauseSeconds = Between(MinPauseSeconds, MaxPauseSeconds);
        _pushSeconds = Between(MinPushSeconds, MaxPushSeconds);
        _pushedSeconds = 0;
        _push = Between(MinPush, MaxPush) * (_random.Next(2) == 0 ? -1 : 1);
    }

    private double Between(double least, double most) => least + (_random.NextDouble() * (most - least));
}
