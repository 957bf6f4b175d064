namespace Harvester.Simulation.Models;

/// <summary>The style of a building.</summary>
public enum BuildingStyle
{
    /// <summary>A house with a hipped roof.</summary>
    House,

    /// <summary>Rows of windows in plaster or brick, with shops on the ground floor.</summary>
    Block,

    /// <summary>Bands of glass between storeys.</summary>
    Tower,

    /// <summary>Sheet metal with a few high windows and a gate.</summary>
    Warehouse,
}
