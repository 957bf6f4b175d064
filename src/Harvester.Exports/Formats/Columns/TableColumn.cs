namespace Harvester.Exports.Formats.Columns;

/// <summary>A column of a table.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Kind">Its type.</param>
/// <param name="Unit">Unit and frame, such as "m, world"; empty for none.</param>
/// <param name="Field">The field of the label that it has, as "camera.position[0]"; empty if it has none.</param>
internal sealed record TableColumn(string Name, ColumnKind Kind, string Unit, string Field)
{
    /// <summary>Whether every row has a value.</summary>
    public bool IsRequired { get; init; }
}
