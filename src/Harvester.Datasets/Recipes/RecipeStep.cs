namespace Harvester.Datasets.Recipes;

/// <summary>One command of a recipe.</summary>
/// <param name="Folder">Name of the folder that it writes, by which later steps refer to it, with an @ before it.</param>
/// <param name="Command">The words of the command, without the name of the program and without --out.</param>
/// <param name="Sha256">
/// SHA-256 of the manifest of the folder, 64 hexadecimal digits in lower case; null in a recipe that is not locked.
/// </param>
public sealed record RecipeStep(string Folder, IReadOnlyList<string> Command, string? Sha256);
