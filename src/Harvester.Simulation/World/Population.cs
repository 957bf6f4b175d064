using Harvester.Geometry;
using Harvester.Simulation.Models;
using Harvester.Simulation.Streets;
using Harvester.Simulation.Traffic;
using RoadNodeFlags = Harvester.Geometry.Roads.RoadNodeFlags;

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

    /// <summary>How far the ends of a parked body may reach into the lane in a bend, beyond its middle, metres.</summary>
    private const double MaxIntoLane = 1;

    /// <summary>Around a place that is visited, metres, there are more vehicles and people: most labels are of what is near.</summary>
    private const double NearEgo = 100;
    private const double VehiclesNearEgo = 14;

    /// <summary>As far as the ego gets in half a minute, metres, there are more of the parked vehicles that are rare elsewhere.</summary>
    private const double ParkedNearEgo = 250;
    private const double BusyFactor = 3;
    private const double AheadFrom = 18;
    private const double AheadTo = 55;
    private const double SameWay = 0.7;

    /// <summary>Distance between places beside a road without kerbs where a vehicle may have been left, metres.</summary>
    private const double RoadsideSlot = 18;
    private const double LeftShare = 0.2;

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
    /// <param name="walkways">The kerbs.</param>
    /// <param name="index">The roads.</param>
    /// <param name="busy">A place that is visited, with all classes around it; null if there is none.</param>
    /// <param name="density">Factor on the number of parked vehicles.</param>
    public List<Prop> Park(IReadOnlyList<Walkway> walkways, StreetIndex index, Vector3D? busy, double density)
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
                    Model model = _mix.PickParked(
                        _random,
                        busy is { } place && Horizontal.Distance(walkway.PlaceBeyondKerb(distance, 0), place) < ParkedNearEgo
                    );
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

    /// <summary>Vehicles left beside roads without kerbs near a place that is visited.</summary>
    /// <param name="roads">The roads.</param>
    /// <param name="index">The roads, by place.</param>
    /// <param name="busy">The place.</param>
    /// <param name="heightAt">Height of the land at a place, metres.</param>
    /// <param name="density">Factor on the number of vehicles.</param>
    public List<Prop> Leave(IEnumerable<Road> roads, StreetIndex index, Vector3D busy, Func<Vector3D, double> heightAt, double density)
    {
        const double fromLane = 0.4;
        const double level = 0.6;
        List<Prop> left = [];
        foreach (Road road in roads.Where(road => !road.IsStreet && !road.IsInner && !road.Flags.HasFlag(RoadNodeFlags.Tunnel)))
        {
            for (
                double distance = road.StartTrim + RoadsideSlot;
                distance < road.Length - road.EndTrim - RoadsideSlot;
                distance += RoadsideSlot
            )
            {
                bool isNear = Horizontal.Distance(road.Curve.PositionAt(distance), busy) < ParkedNearEgo;
                if (!isNear || _random.NextDouble() >= LeftShare * density)
                {
                    continue;
                }

                Model model = _mix.PickLeft(_random);
                bool onRight = _random.Next(2) == 0;
                double beyond = Math.Max(model.Max.X, -model.Min.X) + fromLane;
                double offset = onRight ? road.Layout.RightEdge + beyond : road.Layout.LeftEdge - beyond;
                Vector3D place = road.Curve.OffsetAt(distance, offset);
                if (
                    Math.Abs(heightAt(place) - place.Z) < level
                    && !index.IsOnAnother(road, place, 2 * beyond)
                    && IsClearOfLane(road, distance, onRight, model)
                )
                {
                    bool facesForward = road.Layout.IsOneWay ? road.Layout.Forward > 0 : onRight;
                    Vector3D tangent = road.Curve.TangentAt(distance);
                    Axes axes = Horizontal.AxesAlong(facesForward ? tangent : -tangent);
                    left.Add(new Prop(_handles.Next(), model, _random.Next(), new Pose(place - (axes.Up * model.Min.Z), axes)));
                }
            }
        }

        return left;
    }

    /// <summary>The ego, then the driving vehicles, each clear of the others.</summary>
    /// <param name="placing">Finds places.</param>
    /// <param name="parked">What stands beside the lanes.</param>
    /// <param name="start">Where the ego starts.</param>
    /// <param name="visit">Number of the visited place, around which there is more traffic; null if none is visited.</param>
    /// <param name="density">Factor on the number of vehicles.</param>
    public List<Vehicle> Drive(
        Placing placing,
        IReadOnlyList<Prop> parked,
        (LanePath Path, double Distance) start,
        int? visit,
        double density
    )
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
            Vehicle vehicle = new(_handles.Next(), _mix.PickDriving(_random), _random.Next(), cruise);
            Keep(vehicle, placing.Replace(vehicle, IsFree));
        }

        int near = visit is null ? 0 : (int)Math.Round(VehiclesNearEgo * density);
        for (int i = 0; i < near; i++)
        {
            // The first two go ahead of the ego, so that they are seen: in turn one of each class but cars, which are everywhere.
            bool isAhead = i < 2;
            double cruise = 6 + (5 * _random.NextDouble());
            Model model = isAhead ? _mix.PickInTurn(_random, visit!.Value + (2 * i)) : _mix.PickDriving(_random);
            Vehicle vehicle = new(_handles.Next(), model, _random.Next(), cruise);
            bool isPlaced = isAhead && placing.PutWhere(vehicle, IsAhead, IsFree);
            Keep(vehicle, isPlaced || placing.PutWhere(vehicle, IsNear, IsFree));
        }

        return vehicles;

        bool IsFree(Footprint place) => !taken.Near(place.Centre).Any(place.Overlaps);

        bool IsNear(Vector3D place, Vector3D tangent) => Horizontal.Distance(place, ego.Pose.Position) < NearEgo;

        bool IsAhead(Vector3D place, Vector3D tangent)
        {
            Vector3D forward = ego.Pose.Axes.Forward;
            double ahead = (place - ego.Pose.Position).Dot(forward);
            return IsNear(place, tangent)
                && ahead is > AheadFrom and < AheadTo
                && tangent.Dot(forward) > SameWay * tangent.Length
                && Math.Abs((place - ego.Pose.Position).Dot(ego.Pose.Axes.Right)) < ahead / 2;
        }

        void Keep(Vehicle vehicle, bool isPlaced)
        {
            if (isPlaced)
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
            bool isBusy =
                busy is { } place && Horizontal.Distance(walkway.PlaceBeyondKerb((walkway.From + walkway.To) / 2, 0), place) < NearEgo;
            double expected = walkway.Length * WalkersPerMetre * density * (isBusy ? BusyFactor : 1);
            int count = (int)(expected + _random.NextDouble());
            for (int i = 0; i < count; i++)
            {
                walkers.Add(new Walker(_handles.Next(), Pick(_catalogue.Pedestrians), _random.Next(), walkway));
            }
        }

        return walkers;
    }

    private void ParkAt(List<Prop> parked, Walkway walkway, double distance, StreetIndex index, Model model)
    {
        const double roomAtKerb = 0.05;
        Road road = walkway.Road;
        double fromKerb = Math.Max(FromKerb, Math.Max(model.Max.X, -model.Min.X) + roomAtKerb);
        Vector3D place = road.Curve.OffsetAt(distance, walkway.OffsetBeyondKerb(-fromKerb));
        const double clearOfOtherRoads = 2;
        if (index.IsOnAnother(road, place, clearOfOtherRoads) || !IsClearOfLane(road, distance, walkway.OnRight, model))
        {
            return;
        }

        bool facesForward = road.Layout.IsOneWay ? road.Layout.Forward > 0 : walkway.OnRight;
        Vector3D tangent = road.Curve.TangentAt(distance);
        Axes axes = Horizontal.AxesAlong(facesForward ? tangent : -tangent);
        parked.Add(new Prop(_handles.Next(), model, _random.Next(), new Pose(place - (axes.Up * model.Min.Z), axes)));
    }

    /// <summary>Whether a straight body beside a road leaves the lane free: in a bend towards it, its ends reach into the lane.</summary>
    private static bool IsClearOfLane(Road road, double distance, bool onRight, Model model)
    {
        double half = (model.Max.Y - model.Min.Y) / 2;
        Vector3D middle = road.Curve.PositionAt(distance);
        Vector3D right = Horizontal.AxesAlong(road.Curve.TangentAt(distance)).Right;
        return IsFree(distance - half) && IsFree(distance + half);

        bool IsFree(double end)
        {
            double bend = (road.Curve.PositionAt(Math.Clamp(end, 0, road.Length)) - middle).Dot(right);
            return (onRight ? bend : -bend) <= MaxIntoLane;
        }
    }

    private Model Pick(IReadOnlyList<Model> models) => models[_random.Next(models.Count)];
}
