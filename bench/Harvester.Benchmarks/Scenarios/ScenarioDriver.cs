using Harvester.Driving.Controllers;

namespace Harvester.Benchmarks.Scenarios;

/// <summary>A driver of the ego in scenarios.</summary>
/// <param name="Name">Its name in the table.</param>
/// <param name="Plan">The controller that drives where the lanes are known; null for the simulated game's own driver alone.</param>
/// <param name="IsBlind">Whether the game's own driver takes no notice of the actors.</param>
internal sealed record ScenarioDriver(string Name, ControllerPlan? Plan, bool IsBlind)
{
    /// <summary>The game's own driver, and both controllers, each with and without a brake.</summary>
    public static IReadOnlyList<ScenarioDriver> All { get; } =
    [
        new("own", null, IsBlind: false),
        new("own, --brake off", null, IsBlind: true),
        new("stanley", new ControllerPlan { Kind = ControllerKind.Stanley }, IsBlind: true),
        new("stanley, brake", new ControllerPlan { Kind = ControllerKind.Stanley, BrakesInEmergency = true }, IsBlind: true),
        new("deepdriving", new ControllerPlan { Kind = ControllerKind.DeepDriving }, IsBlind: true),
        new("deepdriving, brake", new ControllerPlan { Kind = ControllerKind.DeepDriving, BrakesInEmergency = true }, IsBlind: true),
    ];
}
