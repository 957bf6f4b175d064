using System;
using Harvester.Geometry;

namespace Harvester.Capture.Ports;

/// <summary>The ego as a car that can be driven from outside: by a client of the live bridge or by a controller.</summary>
public interface IDrivenCar
{
    /// <summary>Whether the player pressed a driving key since the last tick; the car is then the player's again.</summary>
    bool IsTakenByPlayer { get; }

    /// <summary>Sets wheel and pedals for the coming tick. Without a call in a tick the car is not driven from outside.</summary>
    void Drive(DrivingControls controls);

    /// <summary>Puts the car somewhere, standing, its wheels on the ground.</summary>
    /// <param name="position">Origin of the car, world frame, metres; the height is a hint.</param>
    /// <param name="headingDegrees">Counter-clockwise from north, degrees.</param>
    void Reset(Vector3D position, double headingDegrees);

    /// <summary>Sets what is not null.</summary>
    /// <param name="weather">One of the game's own names.</param>
    /// <param name="timeOfDay">From 0 to less than 24 hours.</param>
    /// <exception cref="ArgumentException">The weather is none of the game's.</exception>
    void SetEnvironment(string? weather, TimeSpan? timeOfDay);
}
