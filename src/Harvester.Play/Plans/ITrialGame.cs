using Harvester.Geometry;

namespace Harvester.Play.Plans;

/// <summary>What running the trials of a plan needs of the game, besides <see cref="Features.ICarControls"/>.</summary>
public interface ITrialGame
{
    /// <summary>Whether the scene asked for by <see cref="BeginLoading"/> is loaded.</summary>
    bool IsSceneLoaded { get; }

    /// <summary>Reads the situation.</summary>
    /// <param name="vehicle">The vehicle of the trial; 0 before it has one.</param>
    GameSituation Read(int vehicle);

    /// <summary>Makes player and vehicle invulnerable, and lets the police ignore them.</summary>
    void Protect(int vehicle);

    /// <summary>Lets the player and the vehicle be hurt again, and the police see them.</summary>
    void Unprotect(int vehicle);

    /// <summary>Ends the search of the police.</summary>
    void ClearWanted();

    /// <summary>Ends a cut scene.</summary>
    void EndCutScene();

    /// <summary>Puts the player onto the driver's seat of a vehicle.</summary>
    void EnterVehicle(int vehicle);

    /// <summary>Repairs a vehicle, body and engine, so that each attempt begins with a whole one.</summary>
    void Repair(int vehicle);

    /// <summary>Begins to load the scene around a place.</summary>
    void BeginLoading(Vector3D place);

    /// <summary>Ends the loading of a scene, complete or not. Calling it without one has no effect.</summary>
    void EndLoading();

    /// <summary>Asks for the collision of a place; to be repeated in every tick until it is there.</summary>
    void RequestCollision(Vector3D place);

    /// <summary>Whether the collision around a vehicle is loaded.</summary>
    bool HasCollision(int vehicle);

    /// <summary>Height of the ground below a place, metres; null while it is not loaded.</summary>
    double? GroundBelow(Vector3D place);

    /// <summary>Moves a vehicle anywhere, without regard to the ground, and holds it there, or lets it go.</summary>
    void Hold(int vehicle, Vector3D? place);

    /// <summary>Sets the factors on the numbers of moving vehicles, people and parked vehicles, for this frame.</summary>
    void SetDensities(double traffic, double pedestrians, double parked);

    /// <summary>Lets the game's own driver drive along the roads, by the rules, from now on.</summary>
    /// <param name="vehicle">The vehicle in which the player sits.</param>
    /// <param name="speedMetresPerSecond">The greatest speed, m/s.</param>
    void DriveAlongRoads(int vehicle, double speedMetresPerSecond);

    /// <summary>Gives the vehicle back to the player.</summary>
    void StopDriving();
}
