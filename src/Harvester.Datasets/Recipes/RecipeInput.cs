namespace Harvester.Datasets.Recipes;

/// <summary>A file that a dataset is made from and that does not come with its recipe, such as a road network.</summary>
/// <param name="Name">The name by which steps refer to it, with an @ before it.</param>
/// <param name="Sha256">SHA-256 of the file, 64 hexadecimal digits in lower case; null in a recipe that is not locked.</param>
public sealed record RecipeInput(string Name, string? Sha256);
