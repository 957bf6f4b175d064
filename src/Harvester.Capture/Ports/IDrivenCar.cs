using Harvester.Geometry;

namespace Harvester.Capture.Ports;

/// <summary>The ego as a car that a client of the live bridge or a controller drives.</summary>
public interface IDrivenCar
{
    /// <summary>Whether the player pressed a driving key since the last tick; the player then has control of the car again.</summary>
    bool IsTakenByPlayer { get; }

    /// <summary>Sets steering and pedals for the coming tick. The car is driven only in ticks with a call.</summary>
    void Drive(DrivingControls controls);

    /// <summary>Places the car at a position, at rest, with its wheels on the ground.</summary>
    /// <param name="position">Origin of the car, world frame, metres; the height is approximate.</param>
    /// <param name="headingDegrees">Counter-clockwise from north, degrees.</param>
    void Reset(Vector3D position, double headingDegrees);

    /// <summary>Sets weather, time of day or both; null leaves a value unchanged.</summary>
    /// <param name="weather">One of the game's names.</param>
    /// <param name="timeOfDay">At least 0 and less than 24 hours.</param>
    /// <exception cref="ArgumentException">The game has no such weather.</exception>
    void SetEnvironment(string? weather, TimeSpan? timeOfDay);
}
