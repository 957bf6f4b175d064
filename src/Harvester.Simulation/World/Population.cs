using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Geometry;
using Harvester.Simulation.Models;
using Harvester.Simulation.Streets;
using Harvester.Simulation.Traffic;

namespace Harvester.Simulation.World;

/// <summary>Chooses, from a seed, the initial traffic and pedestrians.</summary>
internal sealed class Population
{
    private const double VehiclesPerLaneMetre = 1.0 / 80;
    private const double ParkingSlot = 7;
    private const double ParkingGap = 1;
    private const double ParkedShare = 0.4;
    private const double WalkersPerMetre = 1.0 / 45;
    private const double FromKerb = 1.15;

    /// <summary>Around a place that is visited, metres, there are more vehicles and people: most labels are of what is near.</summary>
    private const double NearEgo = 100;
    private const double VehiclesNearEgo = 14;
    private const double BusyFactor = 3;

    /// <summary>A sports car as in the thesis, of a model whose dimensions are known.</summary>
    private const string EgoModel = "cheetah";

    private readonly Random _random;
    private readonly ModelCatalogue _catalogue;
    private readonly VehicleMix _mix;
    private readonly HandleCounter _handles;

    public Population(int seed, ModelCatalogue catalogue, HandleCounter handles)
    {
        _random = new Random(seed);
        _catalogue = catalogue;
        _handles = handles;
        _mix = new VehicleMix(catalogue);
    }

    /// <summary>Parked vehicles, of which wide ones stand a little on the lane beside them.</summary>
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
                    Model model = _mix.PickParked(_random);
                    double beyondSlot = Math.Max(0, model.Max.Y - model.Min.Y + ParkingGap - ParkingSlot);
                    if (distance + beyondSlot < to)
                    {
                        ParkAt(parked, walkway, distance + (beyondSlot / 2), index, model);
                        distance += beyondSlot;
                    }
                }
            }
        }

        return parked;
    }

    /// <summary>The ego, then the driving vehicles, each clear of the others.</summary>
    public List<Vehicle> Drive(Placing placing, IReadOnlyList<Prop> parked, Vector3D start, bool isBeside, double density)
    {
        const double egoSpeed = 10;
        Vehicle ego = new(_handles.Next(), _catalogue[EgoModel], _random.Next(), egoSpeed);
        placing.PutEgo(ego, start, isBeside);
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
            Add(8 + (4 * _random.NextDouble()), static _ => true);
        }

        int near = isBeside ? (int)(VehiclesNearEgo * density) : 0;
        for (int i = 0; i < near; i++)
        {
            Add(6 + (5 * _random.NextDouble()), place => Horizontal.Distance(place.Centre, start) < NearEgo);
        }

        return vehicles;

        void Add(double cruise, Func<Footprint, bool> isWanted)
        {
            Vehicle vehicle = new(_handles.Next(), _mix.PickDriving(_random), _random.Next(), cruise);
            if (placing.Replace(vehicle, place => isWanted(place) && !taken.Near(place.Centre).Any(place.Overlaps)))
            {
                vehicles.Add(vehicle);
                taken.Add(vehicle.Footprint, vehicle.Pose.Position);
            }
        }
    }

    public List<Walker> Walk(IReadOnlyList<Walkway> walkways, Vector3D? busy, double density)
    {
        List<Walker> walkers = [];
        foreach (Walkway walkway in walkways)
        {
            bool isBusy = busy is { } place
                && Horizontal.Distance(walkway.PlaceBeyondKerb((walkway.From + walkway.To) / 2, 0), place) < NearEgo;
            double expected = walkway.Length * WalkersPerMetre * density * (isBusy ? BusyFactor : 1);
            int count = (int)(expected + _random.NextDouble());
            for (int i = 0; i < count; i++)
            {
                walkers.Add(new Walker(_handles.Next(), Pick(_catalogue.Pedestrians), _random.Next(), walkway));
            }
        }

        return walkers;
    }

    private void ParkAt(List<Prop> parked, Walkway walkway, double distance, RoadIndex index, Model model)
    {
        const double roomAtKerb = 0.05;
        Road road = walkway.Road;
        double fromKerb = Math.Max(FromKerb, Math.Max(model.Max.X, -model.Min.X) + roomAtKerb);
        Vector3D place = road.Curve.OffsetAt(distance, walkway.OffsetBeyondKerb(-fromKerb));
        const double clearOfOtherRoads = 2;
        if (index.IsOnAnother(road, place, clearOfOtherRoads))
        {
            return;
        }

        bool facesForward = road.Layout.IsOneWay ? road.Layout.Forward > 0 : walkway.OnRight;
        Vector3D tangent = road.Curve.TangentAt(distance);
        Axes axes = Horizontal.AxesAlong(facesForward ? tangent : -tangent);
        parked.Add(new Prop(_handles.Next(), model, _random.Next(), new Pose(place - (axes.Up * model.Min.Z), axes)));
    }

    private Model Pick(IReadOnlyList<Model> models) => models[_random.Next(models.Count)];
}
