using System;
using Harvester.Geometry;

namespace Harvester.Play.Features;

/// <summary>The game's controls of the vehicle that the player sits in, and what else a client may ask of the game.</summary>
public interface ICarControls
{
    /// <summary>Whether the player now holds anything by which vehicles are driven or left. What was set here does not count.</summary>
    bool ArePlayers { get; }

    /// <summary>Sets the controls for the next frame, in the place of the player's.</summary>
    /// <param name="steering">-1 (left) to 1 (right).</param>
    /// <param name="throttle">0 to 1.</param>
    /// <param name="brake">0 to 1; a standing vehicle drives backward by it.</param>
    /// <param name="handbrake">Whether the handbrake is pulled.</param>
    void Set(double steering, double throttle, double brake, bool handbrake);

    /// <summary>Puts a vehicle somewhere, standing on the ground.</summary>
    /// <param name="vehicle">The vehicle.</param>
    /// <param name="position">Its origin, metres, world; the height is a hint.</param>
    /// <param name="headingDegrees">Counter-clockwise from north.</param>
    void Place(int vehicle, Vector3D position, double headingDegrees);

    /// <summary>Makes a weather stay; null gives the weather back to the game.</summary>
    /// <param name="weather">One of the game's names, in small letters.</param>
    void KeepWeather(string? weather);

    /// <summary>Sets the hour; it goes on from there.</summary>
    void SetTimeOfDay(TimeSpan timeOfDay);
}
