using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.Linq;
using GTA.Native;
using Harvester.Play.Features;

namespace Harvester.Mod;

/// <summary>Hides and shows entities by the game's natives.</summary>
/// <param name="nearby">Lists the people, who may sit in vehicles.</param>
internal sealed class GameShownEntities(NearbyEntities nearby) : IShownEntities
{
    /// <summary>People farther from the camera are not asked for their vehicle: entities are labelled up to 1,000 m at most.</summary>
    private const double RangeMetres = 1000;

    private string? _process;

    /// <inheritdoc/>
    public string Process => _process ??= ThisProcess();

    /// <inheritdoc/>
    public bool Exists(int entity) => Natives.EntityExists(entity);

    /// <inheritdoc/>
    public bool IsShown(int entity) => Natives.Call<bool>(Hash.IS_ENTITY_VISIBLE, entity);

    /// <inheritdoc/>
    public ILookup<int, int> GroupsOf(IReadOnlyCollection<int> entities) => nearby.Peds(RenderedCamera.Pose.Position, RangeMetres)
        .Select(ped => (Vehicle: Natives.VehicleOf(ped), Occupant: ped))
        .Where(seat => entities.Contains(seat.Vehicle))
        .ToLookup(seat => seat.Vehicle, seat => seat.Occupant);

    /// <inheritdoc/>
    public void Show(int entity, bool isShown) => Natives.Call(Hash.SET_ENTITY_VISIBLE, entity, isShown, false);

    private static string ThisProcess()
    {
        using Process process = System.Diagnostics.Process.GetCurrentProcess();
        return process.Id.ToString(CultureInfo.InvariantCulture) + " "
            + process.StartTime.ToUniversalTime().ToString("yyyyMMdd-HHmmss", CultureInfo.InvariantCulture);
    }
}
