using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Models;
using Harvester.Simulation.Streets;
using Harvester.Simulation.Traffic;

namespace Harvester.Simulation.World;

/// <summary>Chooses, from a seed, the initial traffic and pedestrians.</summary>
internal sealed class Population
{
    private const double VehiclesPerLaneMetre = 1.0 / 80;
    private const double ParkingSlot = 7;
    private const double ParkedShare = 0.4;
    private const double WalkersPerMetre = 1.0 / 45;
    private const double FromKerb = 1.15;

    /// <summary>A sports car as in the thesis, of a model whose dimensions are known.</summary>
    private const string EgoModel = "cheetah";

    private readonly Random _random;
    private readonly ModelCatalogue _catalogue;
    private readonly List<Model> _cars;
    private readonly List<Model> _others;
    private readonly List<Model> _parkable;
    private readonly HandleCounter _handles;

    public Population(int seed, ModelCatalogue catalogue, HandleCounter handles)
    {
        _random = new Random(seed);
        _catalogue = catalogue;
        _handles = handles;
        _cars = [.. catalogue.Vehicles.Where(model => model.Class == ObjectClass.Car)];
        _others = [.. catalogue.Vehicles.Where(model => model.Class is not ObjectClass.Car and not ObjectClass.Trailer)];
        const double widestParked = 2.2;
        _parkable = [.. _cars.Where(model => model.Max.X - model.Min.X < widestParked)];
    }

    /// <summary>Parked vehicles, clear of all lanes.</summary>
    public List<Prop> Park(IReadOnlyList<Walkway> walkways, RoadIndex index, double density)
    {
        List<Prop> parked = [];
        foreach (Walkway walkway in walkways)
        {
            Road road = walkway.Road;
            double from = Math.Max(walkway.From, road.StartTrim) + ParkingSlot;
            double to = Math.Min(walkway.To, road.Length - road.EndTrim) - ParkingSlot;
            for (double distance = from; distance < to; distance += ParkingSlot)
            {
                if (_random.NextDouble() < ParkedShare * density)
                {
                    ParkAt(parked, walkway, distance, index);
                }
            }
        }

        return parked;
    }

    /// <summary>The ego, then the driving vehicles, each clear of the others.</summary>
    public List<Vehicle> Drive(Placing placing, IReadOnlyList<Prop> parked, Vector3D start, double density)
    {
        const double egoSpeed = 10;
        Vehicle ego = new(_handles.Next(), _catalogue[EgoModel], _random.Next(), egoSpeed);
        placing.PutEgo(ego, start);
        List<Vehicle> vehicles = [ego];
        BodyIndex<Footprint> taken = new();
        taken.Add(ego.Footprint, ego.Pose.Position);
        foreach (Prop prop in parked)
        {
            taken.Add(Footprint.Of(prop.Pose, prop.Model.Min, prop.Model.Max), prop.Pose.Position);
        }

        int count = (int)(placing.LaneMetres * VehiclesPerLaneMetre * density);
        for (int i = 0; i < count; i++)
        {
            double cruise = 8 + (4 * _random.NextDouble());
            Vehicle vehicle = new(_handles.Next(), Pick(_random.Next(5) == 0 ? _others : _cars), _random.Next(), cruise);
            if (placing.Replace(vehicle, place => !taken.Near(place.Centre).Any(place.Overlaps)))
            {
                vehicles.Add(vehicle);
                taken.Add(vehicle.Footprint, vehicle.Pose.Position);
            }
        }

        return vehicles;
    }

    public List<Walker> Walk(IReadOnlyList<Walkway> walkways, double density)
    {
        List<Walker> walkers = [];
        foreach (Walkway walkway in walkways)
        {
            double expected = walkway.Length * WalkersPerMetre * density;
            int count = (int)(expected + _random.NextDouble());
            for (int i = 0; i < count; i++)
            {
                walkers.Add(new Walker(_handles.Next(), Pick(_catalogue.Pedestrians), _random.Next(), walkway));
            }
        }

        return walkers;
    }

    private void ParkAt(List<Prop> parked, Walkway walkway, double distance, RoadIndex index)
    {
        Road road = walkway.Road;
        Vector3D place = road.Curve.OffsetAt(distance, walkway.OffsetBeyondKerb(-FromKerb));
        const double clearOfOtherRoads = 2;
        if (index.IsOnAnother(road, place, clearOfOtherRoads))
        {
            return;
        }

        bool facesForward = road.Layout.IsOneWay ? road.Layout.Forward > 0 : walkway.OnRight;
        Vector3D tangent = road.Curve.TangentAt(distance);
        Axes axes = Horizontal.AxesAlong(facesForward ? tangent : -tangent);
        Model model = Pick(_parkable);
        parked.Add(new Prop(_handles.Next(), model, _random.Next(), new Pose(place - (axes.Up * model.Min.Z), axes)));
    }

    private Model Pick(IReadOnlyList<Model> models) => models[_random.Next(models.Count)];
}
