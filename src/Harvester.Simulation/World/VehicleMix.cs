using Harvester.Sessions.Scenes;
using Harvester.Simulation.Models;

namespace Harvester.Simulation.World;

/// <summary>
/// How often each model is met. Lorries, buses and two-wheelers are a little more frequent than on real streets, so that a session of a
/// few hundred frames has examples of each class.
/// </summary>
internal sealed class VehicleMix
{
    /// <summary>Cars up to this width are parked at kerbs, metres.</summary>
    private const double WidestParkedCar = 2.2;

    private const double Rare = 0.3;

    private static readonly (ObjectClass Class, double Share)[] Driving =
    [
        (ObjectClass.Car, 0.71),
        (ObjectClass.Truck, 0.1),
        (ObjectClass.Bus, 0.05),
        (ObjectClass.Motorcycle, 0.07),
        (ObjectClass.Bicycle, 0.07),
    ];

    private static readonly (ObjectClass Class, double Share)[] Parked =
    [
        (ObjectClass.Car, 0.87),
        (ObjectClass.Motorcycle, 0.06),
        (ObjectClass.Trailer, 0.04),
        (ObjectClass.Other, 0.03),
    ];

    private static readonly ObjectClass[] InTurn = [ObjectClass.Bus, ObjectClass.Truck, ObjectClass.Bicycle, ObjectClass.Motorcycle];

    private static readonly (ObjectClass Class, double Share)[] Left =
    [
        (ObjectClass.Car, 0.3),
        (ObjectClass.Trailer, 0.4),
        (ObjectClass.Other, 0.3),
    ];

    /// <summary>At kerbs near a place that is visited there are more of the classes that do not drive.</summary>
    private static readonly (ObjectClass Class, double Share)[] ParkedNear =
    [
        (ObjectClass.Car, 0.7),
        (ObjectClass.Motorcycle, 0.08),
        (ObjectClass.Trailer, 0.12),
        (ObjectClass.Other, 0.1),
    ];

    private readonly ILookup<ObjectClass, Model> _models;

    public VehicleMix(ModelCatalogue catalogue) => _models = catalogue.Vehicles.ToLookup(model => model.Class);

    /// <summary>A vehicle that drives.</summary>
    public Model PickDriving(Random random) => Pick(random, Driving, _ => true);

    /// <summary>A vehicle that drives, of one class after another but cars.</summary>
    public Model PickInTurn(Random random, int number) => Pick(random, [(InTurn[number % InTurn.Length], 1)], _ => true);

    /// <summary>A vehicle that was left beside a road without kerbs.</summary>
    public Model PickLeft(Random random) => Pick(random, Left, _ => true);

    /// <summary>A vehicle that stands at a kerb.</summary>
    /// <param name="random">Decides which.</param>
    /// <param name="isNear">Whether the place is near one that is visited.</param>
    public Model PickParked(Random random, bool isNear) =>
        Pick(random, isNear ? ParkedNear : Parked, model => model.Class != ObjectClass.Car || model.Max.X - model.Min.X < WidestParkedCar);

    private Model Pick(Random random, (ObjectClass Class, double Share)[] shares, Func<Model, bool> isWanted)
    {
        double drawn = random.NextDouble();
        int last = shares.Length - 1;
        int chosen = 0;
        while (chosen < last && drawn >= shares[chosen].Share)
        {
            drawn -= shares[chosen++].Share;
        }

        Model[] models = [.. _models[shares[chosen].Class].Where(isWanted)];
        double weight = random.NextDouble() * models.Sum(WeightOf);
        foreach (Model model in models)
        {
            weight -= WeightOf(model);
            if (weight < 0)
            {
                return model;
            }
        }

        return models[^1];
    }

    private static double WeightOf(Model model)
    {
        bool isPolice = model.Name.StartsWith("police", StringComparison.Ordinal);
        return isPolice || model.Name is "stretch" or "firetruk" or "cheetah" or "infernus" ? Rare : 1;
    }
}
