namespace Harvester.Play.Features;

/// <summary>The game's vehicles, as far as the player and the test car need them.</summary>
public interface IVehicles
{
    /// <summary>The vehicle of the player; 0 on foot.</summary>
    int OfPlayer { get; }

    /// <summary>Whether a vehicle is in the game.</summary>
    bool Exists(int vehicle);

    /// <summary>Creates a vehicle to the player's right, with the player's heading.</summary>
    /// <param name="model">Hash of a loaded model.</param>
    /// <param name="metresBeside">Distance, metres.</param>
    /// <returns>Its handle; 0 if the game has no room for another.</returns>
    int MakeBesidePlayer(int model, double metresBeside);

    /// <summary>Places a vehicle on the ground, makes it indestructible and paints it.</summary>
    /// <param name="vehicle">The vehicle.</param>
    /// <param name="primaryColour">The game's number of the body's colour.</param>
    /// <param name="secondaryColour">The game's number of the other colour.</param>
    /// <param name="plate">The text of the number plate; the game takes 8 letters.</param>
    void Prepare(int vehicle, int primaryColour, int secondaryColour, string plate);

    /// <summary>Removes a vehicle.</summary>
    void Remove(int vehicle);
}
