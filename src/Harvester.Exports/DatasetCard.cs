namespace Harvester.Exports;

/// <summary>What the dataset card on the Hugging Face hub says of a format.</summary>
/// <param name="Reader">Name of the hub's reader of the format.</param>
/// <param name="FilesOf">Pattern of the files of a split, relative to the folder of the dataset.</param>
internal sealed record DatasetCard(string Reader, Func<string, string> FilesOf)
{
    /// <summary>The hub's name for all splits together.</summary>
    public const string AllSplits = "all";

    /// <summary>The name of a split on the hub: names there match <c>^\w+(\.\w+)*$</c>, so they have no hyphens.</summary>
    public static string NameOf(string split) => split.Replace('-', '_');
}
