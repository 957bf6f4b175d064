using System.Diagnostics;
using System.Globalization;
using GTA.Native;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Play.Features;

namespace Harvester.Mod;

/// <summary>Hides and shows entities by the game's natives.</summary>
/// <param name="nearby">Lists what may move with an entity.</param>
internal sealed class GameShownEntities(NearbyEntities nearby) : IShownEntities
{
    /// <summary>People farther from the camera are not asked for their vehicle: entities are labelled up to 1,000 m at most.</summary>
    private const double RangeMetres = 1000;

    /// <summary>Distance within which props are asked whether they are attached to a vehicle; half the length of a long lorry.</summary>
    private const double VehicleReachMetres = 8;

    /// <summary>The same for a person.</summary>
    private const double PersonReachMetres = 2;

    /// <summary>A chain of attachments is followed no farther: an object in a driver's hand, or on a trailer, is two steps long.</summary>
    private const int MaxSteps = 4;

    private const int None = 0;

    private string? _process;

    /// <inheritdoc/>
    public string Process => _process ??= ThisProcess();

    /// <inheritdoc/>
    public bool Exists(int entity) => Natives.EntityExists(entity);

    /// <inheritdoc/>
    public bool IsShown(int entity) => Natives.Call<bool>(Hash.IS_ENTITY_VISIBLE, entity);

    /// <inheritdoc/>
    public ILookup<int, int> GroupsOf(IReadOnlyCollection<int> entities)
    {
        Vector3D camera = RenderedCamera.Pose.Position;
        var carriers = new Dictionary<int, int>();
        IReadOnlyList<int> peds = nearby.Peds(camera, RangeMetres);
        foreach (int ped in peds)
        {
            Add(ped, Natives.VehicleOf(ped));
        }

        var vehicles = nearby.Vehicles(camera, RangeMetres).Where(entities.Contains).ToList();
        foreach (int vehicle in vehicles.ToArray())
        {
            int trailer = Natives.TrailerOf(vehicle);
            if (trailer != None)
            {
                Add(trailer, vehicle);
                vehicles.Add(trailer);
            }
        }

        IEnumerable<int> props = PropsNear(vehicles, VehicleReachMetres)
            .Concat(PropsNear(peds.Where(entities.Contains), PersonReachMetres));
        foreach (int prop in props.Distinct().ToArray())
        {
            Add(prop, Natives.CarrierOf(prop));
        }

        return carriers.Keys.ToLookup(WholeOf);

        void Add(int part, int carrier)
        {
            if (carrier != None)
            {
                carriers[part] = carrier;
            }
        }

        // The first of the entities to which the chain of attachments leads.
        int WholeOf(int part)
        {
            int whole = part;
            for (int step = 0; step < MaxSteps && carriers.TryGetValue(whole, out whole); step++)
            {
                if (entities.Contains(whole))
                {
                    return whole;
                }
            }

            return None;
        }
    }

    /// <inheritdoc/>
    public void Show(int entity, bool isShown) => Natives.Call(Hash.SET_ENTITY_VISIBLE, entity, isShown, false);

    /// <summary>The props near entities. Lists by natives would search for them by rays and are left out.</summary>
    private IEnumerable<int> PropsNear(IEnumerable<int> entities, double radius) =>
        nearby.IsListedByApi(EntityKind.Prop) ? entities.SelectMany(entity => nearby.AllProps(Natives.EntityPosition(entity), radius)) : [];

    private static string ThisProcess()
    {
        using Process process = System.Diagnostics.Process.GetCurrentProcess();
        return process.Id.ToString(CultureInfo.InvariantCulture)
            + " "
            + process.StartTime.ToUniversalTime().ToString("yyyyMMdd-HHmmss", CultureInfo.InvariantCulture);
    }
}
