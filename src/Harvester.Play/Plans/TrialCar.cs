using Harvester.Play.Features;

namespace Harvester.Play.Plans;

/// <summary>
/// The vehicle of the trials: the one in which the player sits, or else the last one, or else a new one, in which the player is put.
/// </summary>
/// <param name="vehicles">The game's vehicles.</param>
/// <param name="models">The game's models.</param>
/// <param name="game">Puts the player into a vehicle, and repairs it.</param>
/// <param name="model">Model of a new vehicle.</param>
public sealed class TrialCar(IVehicles vehicles, IModels models, ITrialGame game, int model)
{
    private const double MetresBeside = 4;
    private const int Black = 0;
    private const int Orange = 38;

    private int _made;
    private bool _isModelHeld;

    /// <summary>The vehicle; 0 before there is one.</summary>
    public int Vehicle { get; private set; }

    /// <summary>Works towards a player in a vehicle, which is repaired then; to be called until it is so.</summary>
    /// <returns>Whether the player sits in the vehicle.</returns>
    public bool Board()
    {
        int boarded = vehicles.OfPlayer;
        if (boarded != 0)
        {
            Vehicle = boarded;
            game.Repair(boarded);
            return true;
        }

        if (Vehicle != 0 && vehicles.Exists(Vehicle))
        {
            game.EnterVehicle(Vehicle);
            return false;
        }

        if (models.IsVehicle(model))
        {
            _isModelHeld = true;
            if (models.Load(model))
            {
                RemoveMade();
                Vehicle = _made = vehicles.MakeBesidePlayer(model, MetresBeside);
                ReleaseModel();
                if (_made != 0)
                {
                    vehicles.Prepare(_made, Black, Orange, "HARVEST");
                }
            }
        }

        return false;
    }

    /// <summary>Removes the vehicle that was made here, and lets the game unload its model.</summary>
    public void Remove()
    {
        RemoveMade();
        ReleaseModel();
    }

    private void RemoveMade()
    {
        if (_made != 0 && vehicles.Exists(_made))
        {
            vehicles.Remove(_made);
        }

        _made = 0;
    }

    private void ReleaseModel()
    {
        if (_isModelHeld)
        {
            models.Release(model);
            _isModelHeld = false;
        }
    }
}
