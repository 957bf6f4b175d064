using System.Diagnostics;
using System.Globalization;
using GTA.Native;
using Harvester.Play.Features;

namespace Harvester.Mod;

/// <summary>Hides and shows entities by the game's natives.</summary>
internal sealed class GameShownEntities : IShownEntities
{
    private string? _process;

    /// <inheritdoc/>
    public string Process => _process ??= ThisProcess();

    /// <inheritdoc/>
    public bool Exists(int entity) => Natives.EntityExists(entity);

    /// <inheritdoc/>
    public bool IsShown(int entity) => Natives.Call<bool>(Hash.IS_ENTITY_VISIBLE, entity);

    /// <inheritdoc/>
    public void Show(int entity, bool isShown) => Natives.Call(Hash.SET_ENTITY_VISIBLE, entity, isShown, false);

    private static string ThisProcess()
    {
        using Process process = System.Diagnostics.Process.GetCurrentProcess();
        return process.Id.ToString(CultureInfo.InvariantCulture) + " "
            + process.StartTime.ToUniversalTime().ToString("yyyyMMdd-HHmmss", CultureInfo.InvariantCulture);
    }
}
