namespace Harvester.Exports.Formats.Columns;

/// <summary>The type of a column.</summary>
internal enum ColumnKind
{
    /// <summary>A whole number of 32 bits.</summary>
    Integer,

    /// <summary>A whole number of 64 bits.</summary>
    Long,

    /// <summary>A number of double precision.</summary>
    Number,

    /// <summary>True or false.</summary>
    Truth,

    /// <summary>A text.</summary>
    Text,

    /// <summary>A text with few values, such as a class: encoded by a dictionary.</summary>
    Word,

    /// <summary>A list of whole numbers.</summary>
    Integers,

    /// <summary>A list of numbers.</summary>
    Numbers,

    /// <summary>A list of texts.</summary>
    Texts,
}
