using Harvester.Geometry;
using Harvester.Play.Features;

namespace Harvester.Play.Plans;

/// <summary>
/// What a trial has taken of the game, and gives back. Each thing is noted before it is taken: if the game refuses to take it back, the
/// next call tries again.
/// </summary>
/// <param name="game">The game.</param>
/// <param name="controls">Sets the weather.</param>
public sealed class TrialGrip(ITrialGame game, ICarControls controls)
{
    private int _protected;
    private int _held;
    private bool _isLoading;
    private bool _isDriven;

    /// <summary>The weather that is kept; null for that of the game.</summary>
    public string? Weather { get; private set; }

    /// <summary>Begins to load the scene around a place.</summary>
    public void BeginLoading(Vector3D place)
    {
        _isLoading = true;
        game.BeginLoading(place);
    }

    /// <summary>Makes player and vehicle invulnerable.</summary>
    public void Protect(int vehicle)
    {
        _protected = vehicle;
        game.Protect(vehicle);
    }

    /// <summary>Holds a vehicle at a place.</summary>
    public void Hold(int vehicle, Vector3D place)
    {
        _held = vehicle;
        game.Hold(vehicle, place);
    }

    /// <summary>Ends the loading, and lets the vehicle go.</summary>
    public void EndLoading()
    {
        if (_isLoading)
        {
            game.EndLoading();
            _isLoading = false;
        }

        if (_held != 0)
        {
            game.Hold(_held, null);
            _held = 0;
        }
    }

    /// <summary>Fixes the weather.</summary>
    public void KeepWeather(string weather)
    {
        Weather = weather;
        controls.KeepWeather(weather);
    }

    /// <summary>Lets the game's own driver drive.</summary>
    public void DriveAlongRoads(int vehicle, double speedMetresPerSecond)
    {
        _isDriven = true;
        game.DriveAlongRoads(vehicle, speedMetresPerSecond);
    }

    /// <summary>Gives everything back except the weather, which the next trial sets again. Calling it again has no effect.</summary>
    public void GiveBack() =>
        Try(
            EndLoading,
            () =>
            {
                if (_isDriven)
                {
                    game.StopDriving();
                    _isDriven = false;
                }
            },
            () =>
            {
                if (_protected != 0)
                {
                    game.Unprotect(_protected);
                    _protected = 0;
                }
            }
        );

    /// <summary>Gives everything back. Calling it again has no effect.</summary>
    public void GiveAllBack() =>
        Try(
            GiveBack,
            () =>
            {
                if (Weather is not null)
                {
                    controls.KeepWeather(null);
                    Weather = null;
                }
            }
        );

    /// <summary>Does each of several things, also after one that fails; the first failure is thrown in the end.</summary>
    private static void Try(params Action[] works)
    {
        var failures = new List<Exception>();
        foreach (Action work in works)
        {
            try
            {
                work();
            }
#pragma warning disable CA1031 // The others are given back all the same.
            catch (Exception exception) when (exception is not System.Threading.ThreadAbortException)
#pragma warning restore CA1031
            {
                failures.Add(exception);
            }
        }

        if (failures.Count > 0)
        {
            throw new AggregateException(failures[0]);
        }
    }
}
