namespace Harvester.Play.Features;

/// <summary>The game's vehicles, as far as the player and the test car need them.</summary>
public interface IVehicles
{
    /// <summary>The vehicle that the player sits in; 0 on foot.</summary>
    int OfPlayer { get; }

    /// <summary>Whether a vehicle is in the game.</summary>
    bool Exists(int vehicle);

    /// <summary>Makes a vehicle to the player's right, looking as the player does.</summary>
    /// <param name="model">Hash of a loaded model.</param>
    /// <param name="metresBeside">How far, metres.</param>
    /// <returns>Its handle; 0 when the game has no room for another.</returns>
    int MakeBesidePlayer(int model, double metresBeside);

    /// <summary>Puts a vehicle on the ground, makes it unbreakable and paints it.</summary>
    /// <param name="vehicle">The vehicle.</param>
    /// <param name="primaryColour">The game's number of the body's colour.</param>
    /// <param name="secondaryColour">The game's number of the other colour.</param>
    /// <param name="plate">What the number plate says; the game takes 8 letters.</param>
    void Prepare(int vehicle, int primaryColour, int secondaryColour, string plate);

    /// <summary>Takes a vehicle out of the game.</summary>
    void Remove(int vehicle);
}
