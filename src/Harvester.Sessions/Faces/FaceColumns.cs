namespace Harvester.Sessions.Faces;

/// <summary>The columns of spaces_of_interest.csv in order, described in data/README.md.</summary>
internal static class FaceColumns
{
    public const string Header = "model,hash,class,name,mutcd,face,fulX,fulY,fulZ,blrX,blrY,blrZ,facing,provenance,source";

    /// <summary>Index of fulX, the first of the six columns of corners.</summary>
    public const int FirstCorner = 6;

    public static readonly string[] Names = Header.Split(',');
}
